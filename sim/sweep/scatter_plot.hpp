#pragma once

#include <string>

#include "sim/sweep/plot_script.hpp"

namespace maquette::sim {

/// The points at `x` and `y`; those whose `band` lies between its bounds are coloured. The machine
/// as described is marked.
[[nodiscard]] std::string scatter_script(const Plot& plot, const PlotData& data);

}  // namespace maquette::sim
