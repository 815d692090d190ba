#include <fmt/format.h>

#include "tools/documentation/documents.hpp"

namespace maquette::documentation {

namespace {

/// Text that roff sets as it is: hyphens that can be copied, and no line that begins as a request.
std::string roff(const std::string& text) {
  std::string result;
  for (const char letter : text) {
    switch (letter) {
      case '\\':
        result += "\\e";
        break;
      case '-':
        result += "\\-";
        break;
      default:
        result += letter;
    }
  }
  return result.find_first_of(".'") == 0 ? "\\&" + result : result;
}

std::string options_text(const std::vector<DocumentedOption>& options) {
  std::string text;
  for (const DocumentedOption& option : options) {
    const std::string flags = joined(option.flags, ", ");
    text +=
        fmt::format(".TP\n{}{}\n{}\n", flags.empty() ? "" : fmt::format("\\fB{}\\fR", roff(flags)),
                    option.value.empty()
                        ? ""
                        : fmt::format("{}\\fI{}\\fR", flags.empty() ? "" : " ", roff(option.value)),
                    roff(option.description));
  }
  return text;
}

std::string examples_text(const std::vector<std::string>& examples) {
  std::string text = ".PP\n.EX\n";
  for (const std::string& example : examples) {
    text += roff(example) + "\n";
  }
  return text + ".EE\n";
}

std::string verb_text(const DocumentedVerb& verb) {
  std::string text = fmt::format(".SS {}\n{}\n", roff(verb.name), roff(verb.description));
  text += options_text(verb.options);
  if (!verb.remarks.empty()) {
    text += ".PP\n";
  }
  for (const std::string& line : verb.remarks) {
    text += roff(line) + "\n";
  }
  return text;
}

}  // namespace

std::string man_page(const DocumentedProgram& program) {
  std::string text =
      fmt::format(".TH MAQUETTE 1 \"\" \"maquette {}\" \"User Commands\"\n", roff(program.version));
  text += ".SH NAME\nmaquette \\- simulate the ray\\-casting machine that CCETT built in 1984\n";
  text += ".SH SYNOPSIS\n.B maquette\n.I VERB\n.RI [ ARGUMENTS ]\n";
  text += fmt::format(".SH DESCRIPTION\n{}\n", roff(program.description));
  text += ".SH OPTIONS\n" + options_text(program.options) + ".SH VERBS\n";
  for (const DocumentedVerb& verb : program.verbs) {
    text += verb_text(verb);
  }
  text += ".SH EXAMPLES\n";
  for (const DocumentedVerb& verb : program.verbs) {
    if (!verb.examples.empty()) {
      text += examples_text(verb.examples);
    }
  }
  text +=
      ".SH EXIT STATUS\n.TP\n0\nAll is well.\n.TP\n1\nRuns differ, a bound is broken, or the "
      "program "
      "failed.\n.TP\n2\nThe input is wrong; nothing has been written.\n.TP\n130\nThe command was "
      "interrupted.\n";
  return text;
}

}  // namespace maquette::documentation
