#pragma once

#include <cmath>

#include "sim/stability/random_cases.hpp"
#include "sim/stability/trial_scene.hpp"

/// What rays tell of a point, for the laws of secondary rays and of solids.
namespace maquette::sim {

/// The crossing that a ray meets first in front of its origin, and the medium up to there.
template <class Real>
struct FirstAhead {
  bool is_met;
  firmware::Crossing<Real> crossing;
  firmware::SurfaceIndex before;
};

template <class Real>
[[nodiscard]] FirstAhead<Real> first_ahead(TrialScene<Real>& scene,
                                           const firmware::RayQuery<Real>& query) {
  const Crossings<Real> met = scene.crossings(query);
  FirstAhead<Real> result{};
  const std::int32_t index = firmware::first_ahead(met.first, met.count, result.before);
  result.is_met = index < met.count;
  if (result.is_met) {
    result.crossing = met.first[index];
  }
  return result;
}

/// Whether crossings are in order, each into another medium, the last into the void.
template <class Real>
[[nodiscard]] bool has_parity(const Crossings<Real>& crossings) {
  firmware::SurfaceIndex medium = firmware::k_void;
  const firmware::Crossing<Real>* before = nullptr;
  for (const firmware::Crossing<Real>& crossing : crossings) {
    const bool in_order = before == nullptr || before->distance <= crossing.distance;
    if (!in_order || crossing.medium == medium || !std::isfinite(crossing.distance)) {
      return false;
    }
    medium = crossing.medium;
    before = &crossing;
  }
  return medium == firmware::k_void;
}

/// What lies around a point.
struct Surroundings {
  bool is_inside;  ///< of matter
  double
      distance;  ///< about how far the nearest surface is; 0 where lines do not agree on the side
};

/// From the crossings nearest to a point, ahead and behind, on some random lines through it.
[[nodiscard]] inline Surroundings surroundings_of(trial::Random& random, TrialScene<double>& scene,
                                                  const Vector3& point) {
  constexpr int k_lines = 16;
  int inside = 0;
  auto nearest = firmware::far_away<double>();
  for (int line = 0; line < k_lines; ++line) {
    const Vector3 direction = random.direction();
    firmware::SurfaceIndex medium = firmware::k_void;
    for (const firmware::Crossing<double>& crossing :
         scene.crossings(query_of<double>(point, direction))) {
      nearest = firmware::smaller(nearest, std::fabs(crossing.distance));
      medium = crossing.distance > 0 ? medium : crossing.medium;
    }
    inside += medium != firmware::k_void ? 1 : 0;
  }
  const bool agree = inside == 0 || inside == k_lines;
  return {inside == k_lines, agree ? nearest : 0};
}

}  // namespace maquette::sim
