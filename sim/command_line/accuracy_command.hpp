#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace maquette::sim {

/// Adds the verb `accuracy` to the program: a scene at several levels, error against run time. Its
/// purpose is the host's time, so a table and two of its files hold some; the others are the same
/// bytes for the same input. `command` is the command line for the manifest; the exit code goes to
/// `exit_code`. Both must outlive the parsing.
void add_accuracy_command(CLI::App& program, const std::vector<std::string>& command,
                          int& exit_code);

}  // namespace maquette::sim
