#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "sim/sweep/plot.hpp"

namespace maquette::sim {

/// The texts of a command line about plots; those that are not given are empty.
struct PlotOptions {
  std::vector<std::string> columns;
  std::vector<std::string> logarithmic;
  std::string title;
};

/// Adds --plot and what goes with it to a verb.
void add_plot_options(CLI::App& verb, PlotOptions& options);

/// The plots that these options stand for; axes and title are those of all of them. Throws
/// DescriptionError.
std::vector<Plot> plots_of(const PlotOptions& options);

}  // namespace maquette::sim
