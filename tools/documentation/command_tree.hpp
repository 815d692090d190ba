#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace maquette::documentation {

/// An option, or an argument that is known by its place, as the documents show it.
struct DocumentedOption {
  std::vector<std::string> flags;  ///< as in `--set`; empty for an argument
  std::string value;               ///< what follows, as in `FILE`; empty when nothing does
  std::string description;
  bool is_repeatable = false;
  std::vector<std::string> words;  ///< that can stand as the value
  bool takes_files = false;
  bool takes_directories = false;
};

struct DocumentedVerb {
  std::string name;
  std::string description;
  std::vector<DocumentedOption> options;
  std::vector<std::string> remarks;   ///< lines behind the options
  std::vector<std::string> examples;  ///< command lines
};

struct DocumentedProgram {
  std::string name;
  std::string description;
  std::string version;
  std::vector<DocumentedOption> options;
  std::vector<DocumentedVerb> verbs;
};

/// The program as it is declared; the names of shipped descriptions come from the folder of data.
[[nodiscard]] DocumentedProgram documented(const CLI::App& program,
                                           const std::string& data_directory);

/// The options of a verb without its arguments, and the arguments alone.
[[nodiscard]] std::vector<DocumentedOption> named(const std::vector<DocumentedOption>& options);
[[nodiscard]] std::vector<DocumentedOption> positional(
    const std::vector<DocumentedOption>& options);

/// The parts with a separator between them.
[[nodiscard]] std::string joined(const std::vector<std::string>& parts,
                                 const std::string& separator);

/// The text with `by` in front of every character that is among `special`.
[[nodiscard]] std::string escaped(const std::string& text, const std::string& special,
                                  const std::string& by = "\\");

/// The text in single quotes, as POSIX shells and zsh read it.
[[nodiscard]] std::string quoted(const std::string& text);

}  // namespace maquette::documentation
