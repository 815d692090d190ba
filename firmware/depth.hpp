#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/prepared.hpp"

/// The depth that a display with a depth memory gets with each pixel (paper, section VI: 16 bits in
/// Z on the first display).
namespace maquette::firmware {

inline constexpr std::int32_t k_full_depth = 0xFFFF;

/// The depths that the codes span: those of the bounded primitives in front of the eye. Without
/// any, up to twice the distance of the scene's origin.
template <class Real>
[[gnu::noinline]] DepthRange<Real> depth_range(const Database<Real>& database,
                                               const Extent<Real>* extents) {
  Real low = far_away<Real>();
  Real high = constant<Real>(0);
  for (NodeIndex leaf = 0; leaf < database.leaf_count; ++leaf) {
    if (extents[leaf].bounded) {
      low = smaller(low, extents[leaf].box.low.z);
      high = larger(high, extents[leaf].box.high.z);
    }
  }
  low = larger(low, constant<Real>(0));
  if (!(high > low)) {
    low = constant<Real>(0);
    high = constant<Real>(2) * length(database.observer.to_screen[3]);
  }
  return {low, constant<Real>(k_full_depth) / (high - low)};
}

/// The code of a depth: 0 at the near end of the range, full at its far end and beyond.
template <class Real>
[[gnu::noinline]] std::uint16_t depth_code(const DepthRange<Real>& range, Real depth) {
  charge<Real>(Operation::load, 2);
  const Real code = (smaller(depth, far_away<Real>()) - range.low) * range.codes_per_unit;
  const Real inside = larger(constant<Real>(0), smaller(code, constant<Real>(k_full_depth)));
  return static_cast<std::uint16_t>(to_integer(inside));
}

}  // namespace maquette::firmware
