#pragma once

#include <string>

#include "sim/accuracy/level_outcome.hpp"

namespace maquette::sim {

/// An outcome as bytes for another process of this program.
[[nodiscard]] std::string encode_outcome(const LevelOutcome& outcome);

/// The outcome in such bytes. Throws std::runtime_error when they are cut short.
[[nodiscard]] LevelOutcome decode_outcome(const std::string& bytes);

}  // namespace maquette::sim
