#include "models/bus/period.hpp"

#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "models/bus/wide.hpp"

namespace maquette::models {

namespace {

constexpr double k_millihertz_per_hertz = 1e3;
constexpr std::int64_t k_ps_millihertz = 1'000'000'000'000'000;
constexpr double k_highest_hertz = 1e12;

}  // namespace

Period::Period(std::int64_t numerator_ps, std::int64_t denominator)
    : numerator_ps_(numerator_ps), denominator_(denominator) {
  if (numerator_ps <= 0 || denominator <= 0) {
    throw std::invalid_argument("a period must be positive");
  }
  const std::int64_t divisor = std::gcd(numerator_ps, denominator);
  numerator_ps_ /= divisor;
  denominator_ /= divisor;
}

Period Period::of_frequency(double hertz) {
  const double millihertz = hertz * k_millihertz_per_hertz;
  if (!(millihertz >= 1 && hertz <= k_highest_hertz)) {
    throw std::invalid_argument("a frequency must lie between 1 mHz and 1 THz");
  }
  return {k_ps_millihertz, std::llround(millihertz)};
}

Period Period::multiplied(std::int64_t factor) const {
  const std::int64_t divisor = std::gcd(factor, denominator_);
  std::int64_t numerator_ps = 0;
  if (__builtin_mul_overflow(numerator_ps_, factor / divisor, &numerator_ps)) {
    throw std::invalid_argument("a period must not be longer than simulated time");
  }
  return {numerator_ps, denominator_ / divisor};
}

std::int64_t Period::divide_wide(std::int64_t a, std::int64_t b, std::int64_t d, std::int64_t c) {
  constexpr std::int64_t k_largest = std::numeric_limits<std::int64_t>::max();
  const Wide quotient = (static_cast<Wide>(a) * b + c) / d;
  return quotient < k_largest ? static_cast<std::int64_t>(quotient) : k_largest;
}

}  // namespace maquette::models
