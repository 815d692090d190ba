#include "models/board/maquette_ffp/addition_paths.hpp"

namespace maquette::models {

using namespace routine_cost;

RoutineCost add_cost(std::uint32_t d7, std::uint32_t d6) {
  const Alignment alignment = aligned(d7, d6, false);
  if (negative(d7) == negative(d6)) {
    return words(2) + k_not_taken + sum(alignment);
  }
  return words(2) + k_taken + difference(alignment);
}

RoutineCost subtract_cost(std::uint32_t d7, std::uint32_t d6) {
  const Alignment alignment = aligned(d7, d6, true);
  if (negative(d7) != negative(d6)) {
    return words(2) + k_not_taken + sum(alignment);
  }
  return words(2) + k_taken + difference(alignment);
}

}  // namespace maquette::models
