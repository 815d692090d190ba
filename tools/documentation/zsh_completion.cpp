#include <fmt/format.h>

#include "tools/documentation/documents.hpp"

namespace maquette::documentation {

namespace {

/// `message:action` of _arguments for a value.
std::string value_of(const DocumentedOption& option) {
  const std::string words = joined(option.words, " ");
  std::string action = " ";
  if (option.takes_files) {
    action = words.empty() ? "_files" : fmt::format("{{ compadd -- {}; _files }}", words);
  } else if (option.takes_directories) {
    action = "_files -/";
  } else if (!words.empty()) {
    action = fmt::format("({})", words);
  }
  return fmt::format("{}:{}", escaped(option.value, ":\\"), action);
}

std::string specification(const DocumentedOption& option, std::size_t& place) {
  if (option.flags.empty()) {
    return quoted(fmt::format("{}:{}", ++place, value_of(option)));
  }
  return quoted(fmt::format("{}{}[{}]{}", option.is_repeatable ? "*" : "", option.flags.back(),
                            escaped(option.description, "[]\\"),
                            option.value.empty() ? "" : ":" + value_of(option)));
}

std::string specifications(const std::vector<DocumentedOption>& options) {
  std::string text;
  std::size_t place = 0;
  for (const DocumentedOption& option : options) {
    text += fmt::format(" \\\n        {}", specification(option, place));
  }
  return text;
}

}  // namespace

std::string zsh_completion(const DocumentedProgram& program) {
  std::string verbs;
  std::string cases;
  for (const DocumentedVerb& verb : program.verbs) {
    verbs += fmt::format("    {}\n", quoted(verb.name + ":" + escaped(verb.description, "\\")));
    cases += fmt::format("    {})\n      _arguments{}\n      ;;\n", verb.name,
                         specifications(verb.options));
  }
  return fmt::format(
      "#compdef maquette\n# Completes the command line of maquette in zsh.\n_maquette() {{\n"
      "  local context state state_descr line\n  typeset -A opt_args\n  local -a verbs=(\n{}  )\n"
      "  _arguments -C{} \\\n        '1: :->verb' '*:: :->arguments'\n  if [[ $state == verb ]]; "
      "then\n"
      "    _describe verb verbs\n    return\n  fi\n  [[ $state == arguments ]] || return\n"
      "  case $words[1] in\n{}  esac\n}}\n\n_maquette \"$@\"\n",
      verbs, specifications(program.options), cases);
}

}  // namespace maquette::documentation
