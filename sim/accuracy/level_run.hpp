#pragma once

#include <functional>
#include <vector>

#include "sim/accuracy/level_outcome.hpp"
#include "sim/accuracy/level_task.hpp"

namespace maquette::sim {

/// Computes every level `repeats` times, all of them once before any a second time, so that a
/// change of the host's speed meets all. Each in a process of its own with one thread, one after
/// the other, and measured there; the first times are those that tell of tiles as well. `show` is
/// called after each with how many are done. Gives the outcomes by level; nothing when an
/// interruption is requested. Throws DescriptionError for a level whose machine does not work and
/// std::runtime_error for one that fails otherwise.
[[nodiscard]] std::vector<std::vector<LevelOutcome>> run_levels(
    const std::vector<LevelTask>& tasks, int repeats, const std::function<void(int)>& show);

}  // namespace maquette::sim
