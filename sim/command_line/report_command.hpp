#pragma once

#include <CLI/CLI.hpp>

namespace maquette::sim {

/// Declares the verb `report`: results as a page for a browser.
void add_report_command(CLI::App& program);

}  // namespace maquette::sim
