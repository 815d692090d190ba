#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

namespace maquette::sim {

/// All verbs and options of the program: what it parses, and what its manual page and completions
/// are made from. `command` are its arguments, the program's name first; a verb leaves its exit
/// code in `exit_code`. Both must outlive the result.
[[nodiscard]] std::unique_ptr<CLI::App> declare_program(const std::vector<std::string>& command,
                                                        int& exit_code);

}  // namespace maquette::sim
