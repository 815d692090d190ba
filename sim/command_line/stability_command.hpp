#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace maquette::sim {

/// Adds the verb `stability` to the program. `command` are the program's arguments for the
/// manifest. The exit code, which goes to `exit_code`, is 0 when every bound holds and 1 otherwise.
void add_stability_command(CLI::App& program, const std::vector<std::string>& command,
                           int& exit_code);

}  // namespace maquette::sim
