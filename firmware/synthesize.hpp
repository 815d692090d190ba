#pragma once

#include "firmware/depth.hpp"
#include "firmware/projection.hpp"
#include "firmware/ray_tree.hpp"

namespace maquette::firmware {

/// A pixel as synthesis gives it.
template <class Counts>
struct CountedPixel {
  std::uint32_t rgb;    ///< 0xRRGGBB
  std::uint16_t depth;  ///< code of its depth, where the display takes one
  Counts rays;
};

using Pixel = CountedPixel<RayCounts>;
template <class Real>
using PixelOf = CountedPixel<RayCountsOf<Real>>;

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

/// The ray through a pixel's centre, in the screen frame; its length is such that the depth grows
/// by 1 per unit of distance.
template <Projection projection, class Real>
RayQuery<Real> primary_ray(const Observer<Real>& observer, std::int16_t column, std::int16_t row) {
  const Real zero = constant<Real>(0);
  charge<Real>(Operation::load, 3);
  if constexpr (projection == Projection::parallel) {
    return {{{observer.left + from_integer<Real>(column) * observer.step,
              observer.top - from_integer<Real>(row) * observer.step, zero},
             {zero, zero, constant<Real>(1)}},
            far_away<Real>(),
            true,
            column,
            row};
  }
  return {{{zero, zero, zero},
           {observer.left + from_integer<Real>(column) * observer.step,
            observer.top - from_integer<Real>(row) * observer.step, constant<Real>(1)}},
          far_away<Real>(),
          true,
          column,
          row};
}

/// The same of the scene's own projection.
template <class Real>
RayQuery<Real> primary_ray(const Database<Real>& database, std::int16_t column, std::int16_t row) {
  return is_parallel(database)
             ? primary_ray<Projection::parallel>(database.observer, column, row)
             : primary_ray<Projection::perspective>(database.observer, column, row);
}

/// What a display can show of a luminance: a light that is brighter than white must not outweigh
/// its neighbours when several rays share a pixel.
template <class Real>
Color<Real> displayable(const Color<Real>& color) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  return {larger(zero, smaller(one, color.x)), larger(zero, smaller(one, color.y)),
          larger(zero, smaller(one, color.z))};
}

/// The rays of a pixel as they are cast: their sum, and how far they lie apart.
template <class Real>
struct SampleSum {
  Color<Real> sum{constant<Real>(0), constant<Real>(0), constant<Real>(0)};
  Color<Real> low{constant<Real>(1), constant<Real>(1), constant<Real>(1)};
  Color<Real> high{constant<Real>(0), constant<Real>(0), constant<Real>(0)};
};

/// Casts the ray through a cell of the grid over a pixel.
template <Projection projection, class Real>
void cast_sample(const Frame<Real>& frame, const WorkArea<Real>& area,
                 const RayQuery<Real>& primary, std::int32_t x, std::int32_t y,
                 SampleSum<Real>& samples, Sight<Real>& sight) {
  const Observer<Real>& observer = frame.database.observer;
  const std::int32_t per_side = frame.database.samples.per_side;
  const Real cell = observer.step / from_integer<Real>(2 * per_side);
  RayQuery<Real> query = primary;
  Vector<Real>& place = projection == Projection::parallel ? query.ray.origin : query.ray.direction;
  place.x += cell * from_integer<Real>(2 * x + 1 - per_side);
  place.y -= cell * from_integer<Real>(2 * y + 1 - per_side);
  const Real nearest = sight.depth;
  sight.depth = far_away<Real>();
  const Color<Real> color = displayable(luminance(frame, query, area, sight));
  sight.depth = smaller(sight.depth, nearest);
  samples.sum += color;
  samples.low = lower(samples.low, color);
  samples.high = higher(samples.high, color);
}

/// Luminance of a pixel as the mean of a regular grid of rays. With a contrast, those in the
/// corners of the grid come first, and only where two of them differ by more in one colour the
/// others (Whitted 1980, of whose neighbouring pixels a board has none).
template <Projection projection, class Real>
[[gnu::noinline]] Color<Real> sampled_luminance(const Frame<Real>& frame,
                                                const RayQuery<Real>& primary,
                                                const WorkArea<Real>& area, Sight<Real>& sight) {
  const Samples<Real>& grid = frame.database.samples;
  const std::int32_t last = grid.per_side - 1;
  charge<Real>(Operation::load, 2);
  SampleSum<Real> samples;
  const bool corners_first = grid.contrast > constant<Real>(0);
  if (corners_first) {
    for (std::int32_t corner = 0; corner < 4; ++corner) {
      cast_sample<projection>(frame, area, primary, (corner & 1) * last, (corner >> 1) * last,
                              samples, sight);
    }
    const Color<Real> apart = samples.high - samples.low;
    if (!(larger(apart.x, larger(apart.y, apart.z)) > grid.contrast)) {
      return samples.sum * constant<Real>(0.25);
    }
  }
  for (std::int32_t y = 0; y <= last; ++y) {
    const bool is_edge = y == 0 || y == last;
    for (std::int32_t x = 0; x <= last; ++x) {
      if (corners_first && is_edge && (x == 0 || x == last)) {
        continue;
      }
      cast_sample<projection>(frame, area, primary, x, y, samples, sight);
    }
  }
  return samples.sum / from_integer<Real>(grid.per_side * grid.per_side);
}

/// Computes one pixel of the useful zone. Independent of every other pixel.
template <Projection projection, class Real>
PixelOf<Real> synthesize(const Frame<Real>& frame, const WorkArea<Real>& area, std::int16_t column,
                         std::int16_t row) {
  charge<Real>(Operation::pixel);
  PixelOf<Real> pixel{};
  const RayQuery<Real> primary = primary_ray<projection>(frame.database.observer, column, row);
  Sight<Real> sight;
  pixel.rgb = rgb_of(frame.database.needs.samples
                         ? sampled_luminance<projection>(frame, primary, area, sight)
                         : luminance(frame, primary, area, sight));
  pixel.rays = sight.rays;
  if (frame.database.needs.depth) {
    pixel.depth = depth_code(frame.prepared.depths, sight.depth);
  }
  return pixel;
}

/// The same of the scene's own projection.
template <class Real>
[[gnu::always_inline]] inline PixelOf<Real> synthesize(const Frame<Real>& frame,
                                                       const WorkArea<Real>& area,
                                                       std::int16_t column, std::int16_t row) {
  return is_parallel(frame.database)
             ? synthesize<Projection::parallel>(frame, area, column, row)
             : synthesize<Projection::perspective>(frame, area, column, row);
}

}  // namespace maquette::firmware
