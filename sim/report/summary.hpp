#pragma once

#include <string>

#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// The text that a run prints at its end: frame time, states of each board, bus, rays, the dearest
/// operation classes, and the host's time (seconds of wall clock). `times_from` says what the
/// boards' times are told from, `paper_time` the time that the paper states, beside which that of a
/// whole frame is put; empty where it states none.
std::string summarise(const Statistics& statistics, const std::string& times_from,
                      const std::string& paper_time, double host_time_s);

}  // namespace maquette::sim
