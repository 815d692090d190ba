#pragma once

#include <string>
#include <vector>

#include "tools/benchmark/child_process.hpp"
#include "tools/benchmark/rows.hpp"

namespace maquette::benchmark {

/// A run of photo4 with one thread, into this folder of the scratch directory, with more arguments.
/// Throws as run_process.
ProcessUsage run_simulation(const Paths& paths, const std::string& folder,
                            const std::vector<std::string>& arguments);

}  // namespace maquette::benchmark
