#pragma once

#include <cstdint>
#include <optional>

#include "models/bus/instant.hpp"

namespace maquette::models {

/// What the host did on the buses of a machine, exact in ticks.
struct HostStatistics {
  std::optional<Instant> finished;  ///< all boards loaded and started, when they are
  std::int64_t words = 0;
  Duration waited{};
  Duration transferred{};
};

}  // namespace maquette::models
