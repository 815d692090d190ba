#pragma once

#include "firmware/primitives/patch_net.hpp"

/// How often the boundary of a patch's image goes around the ray, counter-clockwise: as often as
/// the ray meets the patch, from behind less often from the front. What two patches, or two halves
/// of one, have in common is bisected to the same numbers from both sides. So a ray through their
/// joint meets exactly one of them, and it enters a closed set as often as it leaves it, whatever
/// rounding does.
///
/// The boundary's crossings of the half-line x >= 0, y = 0 are counted; y = 0 counts as above it.
namespace maquette::firmware::patches {

/// Parts of a patch's edge of 2^-limit its length are taken as a point. Not less, so that the cubes
/// of small numbers stay in the range of the number type; and counted from the whole edge, so that
/// both sides of a joint end with the same parts.
template <class Real>
inline constexpr int k_edge_bisection_limit = std::numeric_limits<Real>::digits + 4;

/// A curve of the image.
template <class Real>
struct Edge {
  Real x[4];
  Real y[4];
};

template <class Real>
Edge<Real> edge_of(const Image<Real>& image, int first, int step) {
  Edge<Real> edge;
  for (int i = 0; i < 4; ++i) {
    edge.x[i] = image.x.at[first + i * step];
    edge.y[i] = image.y.at[first + i * step];
  }
  return edge;
}

/// On which sides of an axis the control points of a net or a curve lie.
struct Sides {
  bool below;
  bool above;
};

template <class Real>
Sides sides_of(const Real* ordinates, int count) {
  Sides sides{false, false};
  for (int i = 0; i < count && !(sides.below && sides.above); ++i) {
    const bool is_below = ordinates[i] < constant<Real>(0);
    sides.below |= is_below;
    sides.above |= !is_below;
  }
  return sides;
}

/// Crossings of the half-line upwards less those downwards. Bisects the edge in place, as often as
/// is left of the limit.
template <class Real>
int crossings_of(Edge<Real>& edge, int bisections_left) {
  const Real zero = constant<Real>(0);
  const Sides y = sides_of(edge.y, 4);
  if (!y.below || !y.above) {
    return 0;
  }
  const Sides x = sides_of(edge.x, 4);
  if (!x.above) {
    return 0;
  }
  const int rise = (edge.y[0] < zero ? 1 : 0) - (edge.y[3] < zero ? 1 : 0);
  if (!x.below) {
    return rise;
  }
  if (bisections_left <= 0) {
    return edge.x[0] + edge.x[3] < zero ? 0 : rise;
  }
  Edge<Real> lower;
  bisect_curve(edge.x, lower.x, 1);
  bisect_curve(edge.y, lower.y, 1);
  const int of_lower = crossings_of(lower, bisections_left - 1);
  return of_lower + crossings_of(edge, bisections_left - 1);
}

template <class Real>
int edge_crossings(const Image<Real>& image, int first, int step, int bisections) {
  Edge<Real> edge = edge_of(image, first, step);
  return crossings_of(edge, k_edge_bisection_limit<Real> - bisections);
}

/// Turns of the boundary, u before v, around the ray. The image is that of a part of a patch, after
/// so many bisections along u and v.
template <class Real>
int winding_of(const Image<Real>& image, int along_u, int along_v) {
  return edge_crossings(image, 0, 4, along_u) + edge_crossings(image, 12, 1, along_v) -
         edge_crossings(image, 3, 4, along_u) - edge_crossings(image, 0, 1, along_v);
}

}  // namespace maquette::firmware::patches
