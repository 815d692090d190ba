#pragma once

#include <optional>

#include "sim/accuracy/level_outcome.hpp"
#include "sim/accuracy/level_task.hpp"

namespace maquette::sim {

/// Computes a level on one thread of this process, which may do so once. The times of its tiles are
/// made only with `with_tiles`, after the host's time has been taken. Nothing when an interruption
/// was requested. Throws as simulate.
[[nodiscard]] std::optional<LevelOutcome> computed_level(const LevelTask& task, bool with_tiles);

}  // namespace maquette::sim
