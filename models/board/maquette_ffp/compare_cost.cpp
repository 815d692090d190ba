#include "models/board/maquette_ffp/routine_cost.hpp"

namespace maquette::models {

using namespace routine_cost;

RoutineCost compare_cost(std::uint32_t d7, std::uint32_t d6) {
  const bool bytes_differ = (d7 & 0xffU) != (d6 & 0xffU);
  const RoutineCost entered = words(1) + branch(negative(d6));
  if (negative(d6)) {
    if (!negative(d7)) {
      return entered + words(1) + k_taken + words(1) + k_return;
    }
    const RoutineCost compared = entered + words(2) + k_not_taken + branch(bytes_differ);
    return compared + (bytes_differ ? RoutineCost{} : k_long_compare) + k_return;
  }
  const RoutineCost compared = entered + words(1) + branch(bytes_differ);
  if (bytes_differ) {
    return compared + k_return;
  }
  const bool perhaps_zero = (d6 & 0xffU) == 0;
  const RoutineCost mantissas =
      perhaps_zero ? words(2) + long_shift(1) + long_shift(1) + k_long_compare : k_long_compare;
  return compared + words(1) + branch(perhaps_zero) + mantissas + k_return;
}

RoutineCost negate_cost(std::uint32_t d7) {
  return words(1) + branch(d7 == 0) + (d7 == 0 ? RoutineCost{} : k_immediate) + k_return;
}

RoutineCost absolute_cost() { return k_immediate + k_return; }

RoutineCost test_cost(std::uint32_t d7) {
  constexpr RoutineCost k_codes_set{16, 2, 0};  // MOVE from an immediate to CCR
  const bool byte_zero = (d7 & 0xffU) == 0;
  const RoutineCost tested = words(1) + branch(byte_zero);
  if (!byte_zero) {
    return tested + k_return;
  }
  return tested + words(1) + branch(d7 == 0) + (d7 == 0 ? RoutineCost{} : k_codes_set) + k_return;
}

}  // namespace maquette::models
