#pragma once

#include <cstdint>

#include "models/bus/instant.hpp"

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

  /// This period `factor` times. `factor` is positive. Throws std::invalid_argument when the result
  /// is longer than any Duration.
  [[nodiscard]] Period multiplied(std::int64_t factor) const;

  /// The time of n >= 0 periods, rounded down to the picosecond; Duration::max() when it is longer.
  [[nodiscard]] Duration times(std::int64_t n) const {
    return Duration{divide(n, numerator_ps_, denominator_)};
  }

  /// The last n with times(n) <= elapsed. `elapsed` is not negative.
  [[nodiscard]] std::int64_t index_at(Duration elapsed) const {
    return denominator_ == 1 ? elapsed.count() / numerator_ps_
                             : divide(elapsed.count() + 1, denominator_, numerator_ps_, -1);
  }

  /// The fewest periods that last at least `span` (the exact product, before rounding).
  [[nodiscard]] std::int64_t count_to_cover(Duration span) const {
    return span <= Duration::zero()
               ? 0
               : divide(span.count(), denominator_, numerator_ps_, numerator_ps_ - 1);
  }

 private:
  // (a b + c) / d without overflow of the product; not negative, rounded down, and the largest
  // number when it is larger.
  [[nodiscard]] static std::int64_t divide(std::int64_t a, std::int64_t b, std::int64_t d,
                                           std::int64_t c = 0) {
    std::int64_t product = 0;
    std::int64_t sum = 0;
    if (__builtin_mul_overflow(a, b, &product) || __builtin_add_overflow(product, c, &sum)) {
      return divide_wide(a, b, d, c);
    }
    return sum / d;
  }
  static std::int64_t divide_wide(std::int64_t a, std::int64_t b, std::int64_t d, std::int64_t c);

  std::int64_t numerator_ps_;
  std::int64_t denominator_;
};

}  // namespace maquette::models
