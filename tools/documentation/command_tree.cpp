#include "tools/documentation/command_tree.hpp"

#include <algorithm>
#include <sstream>

#include "sim/command_line/version.hpp"
#include "sim/scene/shipped_descriptions.hpp"

namespace maquette::documentation {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.push_back(part);
  }
  return parts;
}

void add_names(const std::string& data_directory, const char* kind,
               std::vector<std::string>& words) {
  for (const auto& description : sim::shipped_descriptions(data_directory, kind)) {
    words.push_back(description.name);
  }
}

/// The parser shows choices as `TYPE:{a,b}` and ranges as `TYPE:TYPE in [1 - 9]`.
void read_value(const std::string& type, const std::string& data_directory,
                DocumentedOption& option) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  if (open != std::string::npos && close != std::string::npos) {
    option.words = split(type.substr(open + 1, close - open - 1), ',');
    option.value = joined(option.words, "|");
    return;
  }
  option.value = type.substr(0, type.find(':'));
  for (const std::string& kind : split(option.value, '|')) {
    option.takes_files = option.takes_files || kind == "FILE";
    option.takes_directories = option.takes_directories || kind == "DIR";
    if (kind == "SCENE") {
      add_names(data_directory, "scenes", option.words);
    } else if (kind == "MACHINE") {
      add_names(data_directory, "machines", option.words);
    } else if (kind == "STUDY") {
      add_names(data_directory, "studies", option.words);
    }
  }
}

std::vector<DocumentedOption> options_of(const CLI::App& app, const std::string& data_directory) {
  std::vector<DocumentedOption> options;
  for (const CLI::Option* declared : app.get_options()) {
    DocumentedOption option;
    for (const std::string& name : declared->get_snames()) {
      option.flags.push_back("-" + name);
    }
    for (const std::string& name : declared->get_lnames()) {
      option.flags.push_back("--" + name);
    }
    option.description = declared->get_description();
    if (!declared->get_default_str().empty()) {
      option.description += " (default: " + declared->get_default_str() + ")";
    }
    option.is_repeatable = declared->get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    if (declared->get_items_expected_max() > 0) {
      read_value(declared->get_type_name(), data_directory, option);
    }
    options.push_back(option);
  }
  return options;
}

}  // namespace

DocumentedProgram documented(const CLI::App& program, const std::string& data_directory) {
  DocumentedProgram result{program.get_name(),
                           program.get_description(),
                           sim::version(),
                           options_of(program, data_directory),
                           {}};
  for (const CLI::App* app : program.get_subcommands([](const CLI::App*) { return true; })) {
    DocumentedVerb verb{
        app->get_name(), app->get_description(), options_of(*app, data_directory), {}, {}};
    for (const std::string& line : split(app->get_footer(), '\n')) {
      if (line.rfind("  ", 0) == 0) {
        verb.examples.push_back(line.substr(2));
      } else if (!line.empty() && line != "Examples:") {
        verb.remarks.push_back(line);
      }
    }
    result.verbs.push_back(verb);
  }
  return result;
}

std::vector<DocumentedOption> named(const std::vector<DocumentedOption>& options) {
  std::vector<DocumentedOption> result;
  std::copy_if(options.begin(), options.end(), std::back_inserter(result),
               [](const DocumentedOption& option) { return !option.flags.empty(); });
  return result;
}

std::vector<DocumentedOption> positional(const std::vector<DocumentedOption>& options) {
  std::vector<DocumentedOption> result;
  std::copy_if(options.begin(), options.end(), std::back_inserter(result),
               [](const DocumentedOption& option) { return option.flags.empty(); });
  return result;
}

std::string joined(const std::vector<std::string>& parts, const std::string& separator) {
  std::string text;
  for (const std::string& part : parts) {
    text += (text.empty() ? "" : separator) + part;
  }
  return text;
}

std::string escaped(const std::string& text, const std::string& special, const std::string& by) {
  std::string result;
  for (const char letter : text) {
    if (special.find(letter) != std::string::npos) {
      result += by;
    }
    result += letter;
  }
  return result;
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char letter : text) {
    result += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  }
  return result + "'";
}

}  // namespace maquette::documentation
