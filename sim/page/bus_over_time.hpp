#pragma once

#include "sim/page/html.hpp"
#include "sim/page/run_results.hpp"

namespace maquette::sim {

/// How far the bus was used and waited for over the time of the frame, from the maps of the pixels:
/// what each took of the bus and waited for it, at the instant at which it was written. Empty
/// without those maps.
[[nodiscard]] Html bus_over_time(const RunResults& results);

}  // namespace maquette::sim
