#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace maquette::sim {

/// Adds the verb `run` to the program. `command` is the command line for the manifest; the exit
/// code goes to `exit_code`. Both must outlive the parsing.
void add_run_command(CLI::App& program, const std::vector<std::string>& command, int& exit_code);

}  // namespace maquette::sim
