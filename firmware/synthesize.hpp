#pragma once

#include "firmware/depth.hpp"
#include "firmware/ray_tree.hpp"

namespace maquette::firmware {

/// A pixel as synthesis gives it.
struct Pixel {
  std::uint32_t rgb;    ///< 0xRRGGBB
  std::uint16_t depth;  ///< code of its depth, where the display takes one
  RayCounts rays;
};

/// A component of luminance as eight bits: 0 is black, 1 and above is 255, rounded to nearest.
template <class Real>
std::uint32_t component_of(Real luminance) {
  const Real inside = larger(constant<Real>(0), smaller(constant<Real>(1), luminance));
  return static_cast<std::uint32_t>(to_integer(inside * constant<Real>(255) + constant<Real>(0.5)));
}

template <class Real>
std::uint32_t rgb_of(const Color<Real>& color) {
  return component_of(color.x) << 16U | component_of(color.y) << 8U | component_of(color.z);
}

/// The ray from the eye through a pixel's centre, in the screen frame; its length is such that the
/// depth grows by 1 per unit of distance.
template <class Real>
RayQuery<Real> primary_ray(const Observer<Real>& observer, std::int16_t column, std::int16_t row) {
  const Real zero = constant<Real>(0);
  charge<Real>(Operation::load, 3);
  return {{{zero, zero, zero},
           {observer.left + from_integer<Real>(column) * observer.step,
            observer.top - from_integer<Real>(row) * observer.step, constant<Real>(1)}},
          far_away<Real>(),
          true,
          column,
          row};
}

/// Computes one pixel of the useful zone. Independent of every other pixel.
template <class Real>
Pixel synthesize(const Frame<Real>& frame, const WorkArea<Real>& area, std::int16_t column,
                 std::int16_t row) {
  charge<Real>(Operation::pixel);
  Pixel pixel{};
  const RayQuery<Real> primary = primary_ray(frame.database.observer, column, row);
  Sight<Real> sight;
  pixel.rgb = rgb_of(luminance(frame, primary, area, sight));
  pixel.rays = sight.rays;
  if (frame.database.needs.depth) {
    pixel.depth = depth_code(frame.prepared.depths, sight.depth);
  }
  return pixel;
}

}  // namespace maquette::firmware
