#pragma once

#include <string>

#include "tools/documentation/command_tree.hpp"

namespace maquette::documentation {

/// The manual page of section 1, in the man macros of roff.
[[nodiscard]] std::string man_page(const DocumentedProgram& program);

/// What the shells complete: verbs, options, and values.
[[nodiscard]] std::string bash_completion(const DocumentedProgram& program);
[[nodiscard]] std::string zsh_completion(const DocumentedProgram& program);
[[nodiscard]] std::string fish_completion(const DocumentedProgram& program);

}  // namespace maquette::documentation
