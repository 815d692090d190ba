#pragma once

#include <cstdint>

#include "firmware/database.hpp"
#include "firmware/primitives/primitive_table.hpp"

/// How much room synthesis needs to write on: crossings of one ray, and rays that wait.
namespace maquette::firmware {

/// The most crossings that a ray can have with a node, and the space its evaluation takes.
struct CrossingNeeds {
  std::int64_t result;
  std::int64_t space;
};

template <class Real>
CrossingNeeds crossing_needs_of_leaf(const Database<Real>& database, const Leaf<Real>& leaf) {
  const std::int64_t hits =
      primitive_of<Real>(leaf.kind).hit_limit(database.parameters + leaf.first_parameter);
  return {hits, hits};
}

/// Operands lie one behind the other, their combination behind both.
constexpr CrossingNeeds combined_crossing_needs(const CrossingNeeds& a, const CrossingNeeds& b) {
  const std::int64_t result = a.result + b.result;
  const std::int64_t second = a.result + b.space;
  const std::int64_t operands = a.space > second ? a.space : second;
  return {result, operands > 2 * result ? operands : 2 * result};
}

/// Rays that can wait at once: each ray followed leaves at most two, of which one is followed.
constexpr std::int64_t pending_rays_needed(std::int32_t ray_depth, bool transparency) {
  return transparency ? ray_depth + 1 : 1;
}

}  // namespace maquette::firmware
