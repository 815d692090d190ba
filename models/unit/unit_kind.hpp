#pragma once

#include <cstdint>

#include "models/unit/pixel_leg.hpp"

namespace maquette::models {

/// What a function unit does: one stage of the process, or all of secondary rays.
enum class UnitKind : std::uint8_t {
  extents,
  intersection,
  combination,
  photometry,
  secondary_rays  ///< all stages of reflected, refracted and shadow rays
};

inline constexpr int k_unit_kind_count = static_cast<int>(UnitKind::secondary_rays) + 1;

/// The field's name of each kind, in the order of the enumeration.
inline constexpr const char* k_unit_kind_names[k_unit_kind_count] = {
    "extents", "intersection", "combination", "photometry", "secondary_rays"};

/// Whether a leg is of those that units of a kind do.
constexpr bool serves(UnitKind kind, const PixelLeg& leg) {
  switch (kind) {
    case UnitKind::extents:
      return leg.stage == Stage::extents;
    case UnitKind::intersection:
      return leg.stage == Stage::intersection;
    case UnitKind::combination:
      return leg.stage == Stage::combination;
    case UnitKind::photometry:
      return leg.stage == Stage::photometry;
    case UnitKind::secondary_rays:
      break;
  }
  return leg.ray != firmware::RayKind::primary && leg.stage != Stage::board;
}

}  // namespace maquette::models
