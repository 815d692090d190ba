#include <fmt/format.h>

#include "tools/documentation/documents.hpp"

namespace maquette::documentation {

namespace {

/// The call that offers what can stand as the value.
std::string offer(const DocumentedOption& option) {
  const char* const kind = option.takes_files         ? "files"
                           : option.takes_directories ? "folders"
                                                      : "words";
  return fmt::format("_maquette_{} {}", kind, quoted(joined(option.words, " ")));
}

std::string verb_case(const DocumentedVerb& verb) {
  std::string values;
  std::vector<std::string> flags;
  for (const DocumentedOption& option : named(verb.options)) {
    flags.insert(flags.end(), option.flags.begin(), option.flags.end());
    if (!option.value.empty()) {
      values +=
          fmt::format("        {}) {}; return ;;\n", joined(option.flags, " | "), offer(option));
    }
  }
  const std::vector<DocumentedOption> arguments = positional(verb.options);
  return fmt::format(
      "    {})\n      case $before in\n{}      esac\n"
      "      if [[ $current == -* ]]; then\n        _maquette_words {}\n      else\n        {}\n"
      "      fi\n      ;;\n",
      verb.name, values, quoted(joined(flags, " ")),
      arguments.empty() ? "COMPREPLY=()" : offer(arguments.front()));
}

constexpr const char* k_functions = R"(# Completes the command line of maquette in bash.
_maquette_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}

_maquette_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current"; compgen -f -- "$current")
}

_maquette_folders() {
  compopt -o filenames 2>/dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$current")
}

_maquette() {
  local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} verb= i
  COMPREPLY=()
  # Bash splits --option=value at its `=`.
  if [[ $current == = ]]; then
    current=
  elif [[ $before == = ]]; then
    before=${COMP_WORDS[COMP_CWORD - 2]}
  fi
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ ${COMP_WORDS[i]} == -* ]] || { verb=${COMP_WORDS[i]} && break; }
  done
  case $verb in
)";

}  // namespace

std::string bash_completion(const DocumentedProgram& program) {
  std::vector<std::string> first;
  std::string cases;
  for (const DocumentedVerb& verb : program.verbs) {
    first.push_back(verb.name);
    cases += verb_case(verb);
  }
  for (const DocumentedOption& option : program.options) {
    first.insert(first.end(), option.flags.begin(), option.flags.end());
  }
  return k_functions + fmt::format("    '') _maquette_words {} ;;\n", quoted(joined(first, " "))) +
         cases + "  esac\n}\n\ncomplete -F _maquette maquette\n";
}

}  // namespace maquette::documentation
