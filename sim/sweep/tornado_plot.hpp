#pragma once

#include <string>

#include "sim/sweep/plot_script.hpp"

namespace maquette::sim {

/// For each axis a bar from the least to the greatest `y` that its values alone give, the longest
/// on top, around the line of the machine as described. Of a study that varies one at a time.
[[nodiscard]] std::string tornado_script(const Plot& plot, const PlotData& data);

}  // namespace maquette::sim
