#pragma once

namespace maquette::benchmark {

/// Processor time in seconds of a fixed loop, the median of nine runs: steps that depend on one
/// another and of which each looks up a table of 64 KiB and branches on what it finds, as an
/// interpreter's do. Rates divided by what it reaches compare machines.
double calibration_loop_s();

/// Steps of that loop.
inline constexpr double k_calibration_steps = 2e7;

}  // namespace maquette::benchmark
