#pragma once

#include <CLI/CLI.hpp>

namespace maquette::sim {

/// Adds the verb `compare` to the program. The exit code, which goes to `exit_code`, is 0 for equal
/// runs and 1 for different ones.
void add_compare_command(CLI::App& program, int& exit_code);

}  // namespace maquette::sim
