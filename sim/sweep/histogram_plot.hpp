#pragma once

#include <string>

#include "sim/sweep/plot_script.hpp"

namespace maquette::sim {

/// How many points have which `y`, with their median, the interval that holds the middle 90 % (5 %
/// and 95 % quantiles, interpolated linearly), and the machine as described. A point that varies
/// nothing does not count.
[[nodiscard]] std::string histogram_script(const Plot& plot, const PlotData& data);

}  // namespace maquette::sim
