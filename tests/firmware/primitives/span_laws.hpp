#pragma once

#include <algorithm>
#include <cmath>

#include "firmware/primitives/primitive.hpp"
#include "tests/catch.hpp"

/// What the hits of any primitive must obey.
namespace maquette::firmware::trial {

/// Points along a line at which its hits are held against the solid.
struct Samples {
  double first;
  double step;
  int count;
};

/// So many points on both sides of the ray's nearest to the origin, `length` apart.
inline Samples samples_around(const Ray<double>& ray, int each_way, double length) {
  const double step = length / glm::length(ray.direction);
  const double middle =
      -glm::dot(ray.origin, ray.direction) / glm::dot(ray.direction, ray.direction);
  return {middle + (0.37 - each_way) * step, step, 2 * each_way + 1};
}

/// Requires that hits are even in number, in order, and that a point is inside where an odd number
/// of them lies before it. `outside_by` gives how far a point is outside, negative inside; nearer
/// to the surface than `margin` a point says nothing.
template <class Real, class OutsideBy>
void check_spans(const Hit<Real>* hits, int hit_count, const Ray<double>& ray,
                 const Samples& samples, double margin, OutsideBy outside_by) {
  REQUIRE(hit_count % 2 == 0);
  for (int i = 1; i < hit_count; ++i) {
    REQUIRE(hits[i - 1].distance <= hits[i].distance);
  }
  for (int i = 0; i < samples.count; ++i) {
    const double t = samples.first + i * samples.step;
    const auto passed = std::count_if(hits, hits + hit_count, [t](const Hit<Real>& hit) {
      return static_cast<double>(hit.distance) < t;
    });
    const double outside = outside_by(Vector<double>(ray.origin + ray.direction * t));
    if (std::fabs(outside) > margin) {
      CAPTURE(i, t, outside, hit_count);
      REQUIRE((passed % 2 == 1) == (outside < 0));
    }
  }
}

}  // namespace maquette::firmware::trial
