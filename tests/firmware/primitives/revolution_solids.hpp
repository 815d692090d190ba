#pragma once

#include <cmath>
#include <vector>

#include "firmware/primitives/revolution.hpp"
#include "tests/firmware/generatrices.hpp"
#include "tests/firmware/primitives/parameters_of.hpp"
#include "tests/firmware/random_cases.hpp"

/// Random solids of revolution and rays that meet them.
namespace maquette::firmware::trial {

using revolution::Generatrix;
using revolution::generatrix;

inline const double k_turn = 2 * std::acos(-1.0);

/// A generatrix of either number type, and as a fine chain of chords in the half-plane.
struct Solid {
  std::vector<double> parameters;
  std::vector<float> as_float;
  std::vector<Vector<double>> chain;  ///< (r, z, 0), closed along the axis
};

inline void add_chords(Solid& solid) {
  const Generatrix<double> curve = generatrix(solid.parameters.data());
  constexpr int k_chords = 400;
  if (curve.is_open) {
    solid.chain.emplace_back(0, curve.points[1], 0);
  }
  for (int i = 0; i < curve.sections * k_chords; ++i) {
    const double u = static_cast<double>(i % k_chords) / k_chords;
    const CurvePoint<double> point = curve_point(curve.section(i / k_chords), u);
    solid.chain.emplace_back(point.x, point.y, 0);
  }
  if (curve.is_open) {
    const double* end = curve.section(curve.sections);
    solid.chain.emplace_back(end[0], end[1], 0);
    solid.chain.emplace_back(0, end[1], 0);
  }
}

inline Solid solid_of(const std::vector<double>& control, bool is_open) {
  Solid solid;
  solid.parameters = converted<double>(given_spline(control, is_open));
  solid.as_float.assign(solid.parameters.begin(), solid.parameters.end());
  add_chords(solid);
  return solid;
}

/// A tube around the axis: an outline about a circle in the half-plane, counter-clockwise.
inline Solid random_ring(Random& random, double roughness) {
  const int points = 3 + random.below(8);
  std::vector<double> control;
  for (int i = 0; i < points; ++i) {
    const double angle = k_turn * i / points;
    const double size = 0.4 * (1 - roughness * random.uniform());
    control.push_back(0.55 + size * std::cos(angle));
    control.push_back(size * std::sin(angle));
  }
  return solid_of(control, false);
}

/// A vase from bottom to top; some touch the axis, some have steps and horizontal parts.
inline Solid random_vase(Random& random) {
  const int points = 4 + random.below(12);
  std::vector<double> control;
  double z = -1;
  for (int i = 0; i < points; ++i) {
    const bool is_on_axis = random.below(6) == 0;
    control.push_back(is_on_axis ? 0 : random.uniform(0.1, 1));
    control.push_back(z);
    z += random.below(4) == 0 ? 0 : random.uniform(0, 3.0 / points);
  }
  return solid_of(control, true);
}

struct Place {
  bool is_inside;
  double distance;  ///< to the boundary
};

/// By the crossings of the chain with a horizontal line.
inline Place place_of(const Solid& solid, const Vector<double>& point) {
  const Vector<double> p(std::hypot(point.x, point.y), point.z, 0);
  Place place{false, 1e9};
  for (std::size_t i = 0; i < solid.chain.size(); ++i) {
    const Vector<double>& a = solid.chain[i];
    const Vector<double>& b = solid.chain[(i + 1) % solid.chain.size()];
    const Vector<double> side = b - a;
    const double length_squared = glm::dot(side, side);
    const double along = length_squared > 0 ? glm::dot(p - a, side) / length_squared : 0;
    const double inside = std::fmax(0, std::fmin(1, along));
    if (a.x > 0 || b.x > 0) {
      place.distance = std::fmin(place.distance, glm::length(p - a - side * inside));
    }
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + side.x * (p.y - a.y) / side.y) {
      place.is_inside = !place.is_inside;
    }
  }
  return place;
}

template <class Real>
struct Hits {
  Hit<Real> hits[k_primitive_hit_limit];
  int count;
};

template <class Real>
Hits<Real> hits_on(const Solid& solid, const Vector<double>& origin,
                   const Vector<double>& direction) {
  Hits<Real> found;
  found.count = revolution::intersect<Real>({Vector<Real>(origin), Vector<Real>(direction)},
                                            parameters_of<Real>(solid), found.hits);
  return found;
}

/// Random rays towards the solid, many of them special: level or nearly so, along the axis, through
/// it, steep.
inline Ray<double> random_ray(Random& random, double far) {
  const Vector<double> target = random.in_cube(0.9);
  Vector<double> direction = random.direction();
  switch (random.below(6)) {
    case 0:
      direction.z = 0;
      break;
    case 1:
      direction.z = random.magnitude(1e-12, 1e-1) * (random.coin() ? 1 : -1);
      break;
    case 2:
      direction = {0, 0, direction.z};
      break;
    case 3:
      direction = Vector<double>(target.x, target.y, direction.z);
      break;
    default:
      break;
  }
  direction = glm::normalize(direction);
  return {target - direction * random.uniform(0, far), direction * random.magnitude(0.3, 3)};
}

}  // namespace maquette::firmware::trial
