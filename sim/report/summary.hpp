#pragma once

#include <string>

#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// The text that a run prints at its end: frame time beside the seven minutes of the paper (section
/// V, photograph 4), states of each board, bus, rays, the dearest operation classes, and the
/// host's time (seconds of wall clock). `times_from` says what the boards' times are told from.
std::string summarise(const Statistics& statistics, const std::string& times_from,
                      double host_time_s);

}  // namespace maquette::sim
