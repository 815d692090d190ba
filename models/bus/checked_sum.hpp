#pragma once

#include <stdexcept>

#include "models/bus/duration.hpp"

namespace maquette::models {

/// Of times of several boards or backplanes, each within the longest simulated time. Throws
/// std::overflow_error when their sum is longer than any Duration.
inline Duration checked_sum(Duration a, Duration b) {
  Duration::rep sum = 0;
  if (__builtin_add_overflow(a.count(), b.count(), &sum)) {
    throw std::overflow_error(
        "times of all boards or backplanes together are longer than 106 days, the most that a "
        "figure holds; fewer of them or a faster machine take less");
  }
  return Duration{sum};
}

}  // namespace maquette::models
