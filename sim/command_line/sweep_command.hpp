#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace maquette::sim {

/// Adds the verbs `sweep` (simulate the points of a study) and `merge` (gather them into a table
/// and plots) to the program. `command` is the command line for the manifest; the exit code goes to
/// `exit_code`: 1 when points failed or are missing, 130 when interrupted. Both must outlive the
/// parsing.
void add_sweep_commands(CLI::App& program, const std::vector<std::string>& command, int& exit_code);

}  // namespace maquette::sim
