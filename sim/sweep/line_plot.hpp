#pragma once

#include <string>

#include "sim/sweep/plot_script.hpp"

namespace maquette::sim {

/// Lines of `y` over `x`, one for each value of `series`; the prototype is marked. Points alone
/// where a line would have several values at one place. Texts along `x` stand in the order of the
/// table.
[[nodiscard]] std::string line_script(const Plot& plot, const PlotData& data);

}  // namespace maquette::sim
