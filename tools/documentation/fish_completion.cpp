#include <fmt/format.h>

#include "tools/documentation/documents.hpp"

namespace maquette::documentation {

namespace {

std::string fish_quoted(const std::string& text) { return "'" + escaped(text, "\\'") + "'"; }

std::string line(const DocumentedOption& option, const std::string& condition) {
  std::string text = fmt::format("complete -c maquette -n {}", fish_quoted(condition));
  for (const std::string& flag : option.flags) {
    text += flag.rfind("--", 0) == 0 ? " -l " + flag.substr(2) : " -s " + flag.substr(1);
  }
  if (!option.value.empty()) {
    text += option.takes_files ? " -F" : "";
    text += option.flags.empty() ? "" : option.takes_files ? " -r" : " -x";
    const std::string words =
        option.takes_directories ? "(__fish_complete_directories)" : joined(option.words, " ");
    text += words.empty() ? "" : " -a " + fish_quoted(words);
  }
  return text + " -d " + fish_quoted(option.description) + "\n";
}

}  // namespace

std::string fish_completion(const DocumentedProgram& program) {
  const std::string no_verb = "__fish_use_subcommand";
  std::string text = "# Completes the command line of maquette in fish.\ncomplete -c maquette -f\n";
  for (const DocumentedOption& option : program.options) {
    text += line(option, no_verb);
  }
  for (const DocumentedVerb& verb : program.verbs) {
    text += fmt::format("complete -c maquette -n {} -a {} -d {}\n", no_verb, verb.name,
                        fish_quoted(verb.description));
    for (const DocumentedOption& option : verb.options) {
      text += line(option, "__fish_seen_subcommand_from " + verb.name);
    }
  }
  return text;
}

}  // namespace maquette::documentation
