#pragma once

#include <CLI/CLI.hpp>

namespace maquette::sim {

/// Adds the verb `describe` to the program: what a scene needs and leaves out, the memory map of a
/// board, all parameters with their sources.
void add_describe_command(CLI::App& program);

}  // namespace maquette::sim
