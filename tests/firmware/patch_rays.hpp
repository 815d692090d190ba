#pragma once

#include "firmware/primitives/patches.hpp"
#include "tests/firmware/patch_sets.hpp"

/// Rays against sets of patches, for tests.
namespace maquette::firmware::patches {

using trial::ControlNet;
using trial::ControlNets;
using trial::Parameters;
using trial::Random;

inline constexpr SearchMethod::Value k_methods[] = {SearchMethod::subdivision, SearchMethod::roots};

template <class Real>
struct Hits {
  Hit<Real> hits[k_hit_limit];
  int count;
};

template <class Real>
Hits<Real> hits_on(const Parameters<Real>& parameters, const Ray<double>& ray) {
  Hits<Real> found;
  found.count = intersect<Real>({Vector<Real>(ray.origin), Vector<Real>(ray.direction)},
                                parameters.data(), found.hits);
  return found;
}

/// Towards a point, from nearby or far off, often parallel to an axis or to a plane of two.
inline Ray<double> ray_towards(Random& random, const Vector<double>& target, double far) {
  Vector<double> direction = random.direction();
  for (int axis = 0; axis < 3; ++axis) {
    if (random.below(8) == 0) {
      direction[axis] = random.coin() ? 0 : random.magnitude(1e-12, 1e-1);
    }
  }
  direction = glm::normalize(direction + Vector<double>(0, 0, 1e-30));
  return {target - direction * random.uniform(0, far), direction * random.magnitude(0.3, 3)};
}

}  // namespace maquette::firmware::patches
