#pragma once

#include <string>
#include <vector>

namespace maquette::benchmark {

/// What a finished process has used.
struct ProcessUsage {
  double processor_time_s;  ///< user and system, all threads
  double user_time_s;       ///< of that
  double wall_time_s;
  double peak_memory_bytes;
};

/// Runs a program to its end with its standard output thrown away. Throws std::runtime_error when
/// it cannot be started or fails.
ProcessUsage run_process(const std::vector<std::string>& command);

}  // namespace maquette::benchmark
