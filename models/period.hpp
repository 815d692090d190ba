#pragma once

#include <cstdint>

#include "models/instant.hpp"

namespace maquette::models {

/// An exact period: a positive rational number of picoseconds. The n-th event of a clock of that
/// period stands at floor(n * period); nothing drifts however large n is.
class Period {
 public:
  /// numerator / denominator picoseconds, both positive. Throws std::invalid_argument.
  Period(std::int64_t numerator_ps, std::int64_t denominator);

  /// The period of a frequency, which is taken to the millihertz. Throws std::invalid_argument
  /// outside ]0, 1 THz].
  static Period of_frequency(double hertz);

  /// This period `factor` times. `factor` is positive.
  [[nodiscard]] Period multiplied(std::int64_t factor) const;

  /// The time of n >= 0 periods, rounded down to the picosecond.
  [[nodiscard]] Duration times(std::int64_t n) const;

  /// The last n with times(n) <= elapsed. `elapsed` is not negative.
  [[nodiscard]] std::int64_t index_at(Duration elapsed) const;

  /// The fewest periods that last at least `span` (the exact product, before rounding).
  [[nodiscard]] std::int64_t count_to_cover(Duration span) const;

 private:
  std::int64_t numerator_ps_;
  std::int64_t denominator_;
};

}  // namespace maquette::models
