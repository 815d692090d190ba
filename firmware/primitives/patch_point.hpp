#pragma once

#include "firmware/primitives/patch_net.hpp"

/// Points of a patch, their normals, and which of them is nearest to a point in space.
namespace maquette::firmware::patches {

/// A point of a patch seen from a point in space, with its derivatives.
template <class Real>
struct PatchPoint {
  Vector<Real> apart;  ///< from the point in space
  Vector<Real> along_u;
  Vector<Real> along_v;
};

template <class Real>
PatchPoint<Real> patch_point(const Real* points, Real u, Real v, const Vector<Real>& from) {
  const Basis<Real> of_u = basis_at(u);
  const Basis<Real> of_v = basis_at(v);
  PatchPoint<Real> point;
  for (int axis = 0; axis < 3; ++axis) {
    const Jet<Real> jet = jet_at(points + axis, k_point_reals, of_u, of_v);
    point.apart[axis] = jet.value - from[axis];
    point.along_u[axis] = jet.along_u;
    point.along_v[axis] = jet.along_v;
  }
  return point;
}

/// A place on a patch and its squared distance from a point in space.
template <class Real>
struct Place {
  Real u;
  Real v;
  Real distance_squared;
};

/// Steps of the search from one start; the seeds from which it starts along u and along v.
inline constexpr int k_search_steps = 24;
inline constexpr int k_seeds = 4;

/// Spacings, per unit of the local frame, within which a point lies on the patch.
inline constexpr double k_on_tolerance = 16;

/// The step of Gauss and Newton towards the nearest point; where one parameter does nothing, of the
/// other alone.
template <class Real>
void step_towards(const PatchPoint<Real>& at, Real& step_u, Real& step_v) {
  const Real zero = constant<Real>(0);
  const Real uu = glm::dot(at.along_u, at.along_u);
  const Real vv = glm::dot(at.along_v, at.along_v);
  const Real uv = glm::dot(at.along_u, at.along_v);
  const Real u = glm::dot(at.along_u, at.apart);
  const Real v = glm::dot(at.along_v, at.apart);
  const Real determinant = uu * vv - uv * uv;
  if (determinant > uu * vv * ulps<Real>(16)) {
    const Real inverse = constant<Real>(1) / determinant;
    step_u = (uv * v - vv * u) * inverse;
    step_v = (uv * u - uu * v) * inverse;
    return;
  }
  const bool by_u = uu > vv;
  step_u = by_u ? -u / uu : zero;
  step_v = !by_u && vv > zero ? -v / vv : zero;
}

/// Walks from a place to one whose distance is least around it, inside the patch.
template <class Real>
void descend(const Real* points, const Vector<Real>& target, Place<Real>& place) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  const auto clamped = [&](Real u) { return larger(zero, smaller(u, one)); };
  const Real enough = ulps<Real>(1);
  PatchPoint<Real> at = patch_point(points, place.u, place.v, target);
  place.distance_squared = glm::dot(at.apart, at.apart);
  Real step_u;
  Real step_v;
  step_towards(at, step_u, step_v);
  for (int step = 0; step < k_search_steps; ++step) {
    const Real u = clamped(place.u + step_u);
    const Real v = clamped(place.v + step_v);
    if (larger(absolute(u - place.u), absolute(v - place.v)) <= enough) {
      return;
    }
    at = patch_point(points, u, v, target);
    const Real distance_squared = glm::dot(at.apart, at.apart);
    if (distance_squared < place.distance_squared) {
      place = {u, v, distance_squared};
      step_towards(at, step_u, step_v);
    } else {
      const Real quarter = constant<Real>(0.25);
      step_u *= quarter;
      step_v *= quarter;
    }
  }
}

/// The nearest place to a point, searched from the seeds in the order of their distance until one
/// is found on the patch.
template <class Real>
Place<Real> nearest_place(const Real* points, const Vector<Real>& target) {
  constexpr int k_count = k_seeds * k_seeds;
  Place<Real> seeds[k_count];
  const Real between = constant<Real>(1.0 / k_seeds);
  for (int i = 0; i < k_count; ++i) {
    Place<Real>& seed = seeds[i];
    seed.u = (from_integer<Real>(i / k_seeds) + constant<Real>(0.5)) * between;
    seed.v = (from_integer<Real>(i % k_seeds) + constant<Real>(0.5)) * between;
    const Basis<Real> of_u = basis_at(seed.u);
    const Basis<Real> of_v = basis_at(seed.v);
    seed.distance_squared = constant<Real>(0);
    for (int axis = 0; axis < 3; ++axis) {
      const Real apart = value_at(points + axis, k_point_reals, of_u, of_v) - target[axis];
      seed.distance_squared += apart * apart;
    }
  }
  const Real tolerance = ulps<Real>(k_on_tolerance);
  Place<Real> best{};
  for (int i = 0; i < k_count; ++i) {
    int nearest = i;
    for (int k = i + 1; k < k_count; ++k) {
      if (seeds[k].distance_squared < seeds[nearest].distance_squared) {
        nearest = k;
      }
    }
    Place<Real> found = seeds[nearest];
    seeds[nearest] = seeds[i];
    descend(points, target, found);
    if (i == 0 || found.distance_squared < best.distance_squared) {
      best = found;
    }
    if (best.distance_squared <= tolerance * tolerance) {
      break;
    }
  }
  return best;
}

/// Perpendicular to the patch, u, v and the normal as thumb, first and second finger of the right
/// hand. Where an edge collapses to a point, or sides fall together, a little further inside.
template <class Real>
Vector<Real> normal_at(const Real* points, Real u, Real v) {
  const Real zero = constant<Real>(0);
  Vector<Real> normal(zero, zero, zero);
  Real inwards = zero;
  for (int attempt = 0; attempt < 4; ++attempt) {
    const Real middle = constant<Real>(0.5);
    const PatchPoint<Real> at = patch_point(points, u + (middle - u) * inwards,
                                            v + (middle - v) * inwards, {zero, zero, zero});
    normal = glm::cross(at.along_u, at.along_v);
    const Real size = length(normal);
    const Real largest = glm::dot(at.along_u, at.along_u) + glm::dot(at.along_v, at.along_v);
    if (size > largest * ulps<Real>(64)) {
      return normal * (constant<Real>(1) / size);
    }
    inwards = attempt == 0 ? square_root(ulps<Real>(1)) : inwards * constant<Real>(16);
  }
  return normal;
}

}  // namespace maquette::firmware::patches
