#include "sim/stability/coincident_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/primitives/box.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "sim/scene/placement.hpp"
#include "sim/stability/random_tree.hpp"
#include "sim/stability/tally.hpp"
#include "sim/stability/trial_scene.hpp"

namespace maquette::sim {

namespace {

using firmware::BooleanOperator;
using trial::Random;

constexpr const char* k_group = "csg";
constexpr int k_rays_per_body = 50;
constexpr double k_pi = firmware::elementary::k_pi;
/// Spacings by which elements of a placement are rounded otherwise.
constexpr double k_ulps = 1;
/// The sine of the angle, 0.11 degrees, below which a ray may see both of two coincident faces:
/// crossings farther apart than so many times their rounding are not taken as one.
constexpr double k_grazing_sine = 1 / firmware::preprocessing::k_grazing;

/// The share of rays that may see a skin although their neighbours give no reason: rounding that
/// adds up to more than is expected.
constexpr double k_unlucky = 1e-5;

struct SkinTally {
  int rays = 0;
  int skins = 0;
  int uncertain = 0;  ///< skins on rays whose crossings with the body itself are no better known

  void operator+=(const SkinTally& other) {
    rays += other.rays;
    skins += other.skins;
    uncertain += other.uncertain;
  }
};

/// Where a body stands.
struct Place {
  double size;
  Vector3 center;
  Placement placement;
};

Place random_place(Random& random) {
  const double size = random.magnitude(1e-4, 1e4);
  const Vector3 center = random.in_cube(10) * size;
  return {size, center, random.placement(center, size, 3)};
}

/// Elements off by up to an ulp of the number type.
template <class Real>
Placement rounded_otherwise(Random& random, Placement placement) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      placement[column][row] *=
          1 + random.uniform(-k_ulps, k_ulps) * std::numeric_limits<Real>::epsilon();
    }
  }
  return placement;
}

/// A rotation about z that maps every solid of a primitive onto itself; 0 where there is none.
double own_rotation(Random& random, OwnTurns turns) {
  switch (turns) {
    case OwnTurns::none:
      return 0;
    case OwnTurns::quarters:
      return k_pi / 2;
    case OwnTurns::all:
      return random.uniform(0, 2 * k_pi);
  }
  return 0;
}

/// The origin of a ray in a direction at a target near a body: within the scene, which reaches from
/// the eye to the body.
Vector3 origin_of_ray(Random& random, const Place& place, const Vector3& target,
                      const Vector3& direction) {
  const double way = glm::length(place.center) + 2 * place.size;
  return target - direction * (way * random.uniform(0.5, 2));
}

/// Whether crossings are of a span so short that its ends fall together: a ray that meets an edge
/// within rounding.
template <class Real>
bool is_sliver(const TrialScene<Real>& scene, const firmware::RayQuery<Real>& query,
               const Crossings<Real>& crossings) {
  return crossings.count == 2 &&
         firmware::coincide(scene.frame(), query, crossings.first[0], crossings.first[1]);
}

/// Whether a ray's crossings with the first body are known well enough for those with the other to
/// be taken as one with them: moved aside by what rounding may, it has the same ones. Not so where
/// it grazes a face, passes an edge or meets a singular point.
template <class Real>
bool is_certain(TrialScene<Real>& body, const Vector3& from, const Vector3& direction) {
  const auto query = query_of<Real>(rounded<Real>(from), direction);
  const Crossings<Real> found = body.crossings(query);
  const std::vector<firmware::Crossing<Real>> expected(found.begin(), found.end());
  auto reach = static_cast<double>(body.frame().prepared.leaves[0].scale);
  for (const firmware::Crossing<Real>& crossing : expected) {
    const double distance = std::fabs(static_cast<double>(crossing.distance));
    const bool has_end = distance < static_cast<double>(firmware::far_away<Real>());
    reach = std::max(reach, has_end ? distance : 0);
  }
  const double rounding = firmware::preprocessing::k_crossing_tolerance *
                          std::numeric_limits<Real>::epsilon() *
                          (reach + firmware::magnitude(from));
  for (int axis = 0; axis < 3; ++axis) {
    for (const double aside : {-rounding, rounding}) {
      Vector3 moved = from;
      moved[axis] += aside;
      const Crossings<Real> other = body.crossings(query_of<Real>(rounded<Real>(moved), direction));
      const bool same = std::equal(other.begin(), other.end(), expected.begin(), expected.end(),
                                   [&](const auto& one, const auto& two) {
                                     return firmware::coincide(body.frame(), query, one, two);
                                   });
      if (!same) {
        return false;
      }
    }
  }
  return true;
}

/// A ray at a body of which nothing may be left.
template <class Real>
void try_nothing(Random& random, TrialScene<Real>& body, TrialScene<Real>& rest, const Place& place,
                 SkinTally& tally) {
  const Vector3 aim = place.center + random.in_cube(place.size / 2);
  const Vector3 direction = random.direction();
  const Vector3 from = origin_of_ray(random, place, aim, direction);
  ++tally.rays;
  if (rest.crossings(query_of<Real>(rounded<Real>(from), direction)).count > 0) {
    ++(is_certain(body, from, direction) ? tally.skins : tally.uncertain);
  }
}

template <class Real>
void try_without_itself(Random& random, const SolidFamily& family, SkinTally& tally) {
  const Place place = random_place(random);
  const Object body = random_solid(random, family, place.placement);
  Object other = body;
  const double angle = own_rotation(random, description_of(family.kind).own_turns);
  if (angle != 0 && random.coin()) {
    const Placement turned = concatenated(place.placement, trial::turned({0, 0, 1}, angle));
    other.placement =
        concatenated(turned, concatenated(inverse_of(place.placement), body.placement));
  } else {
    other.placement = rounded_otherwise<Real>(random, body.placement);
  }
  TrialScene<Real> whole(scene_of(body));
  TrialScene<Real> rest(scene_of(combined(BooleanOperator::difference, {body, other})));
  for (int ray = 0; ray < k_rays_per_body; ++ray) {
    try_nothing(random, whole, rest, place, tally);
  }
}

Object cube_at(const Placement& placement) {
  Object cube;
  cube.primitive = primitive_of(BoxShape{{2, 2, 2}});
  cube.surface = k_trial_surfaces[0];
  cube.placement = placement;
  return cube;
}

struct TouchTally {
  int rays = 0;
  int inner_faces = 0;   ///< rays that see the common face in the union
  int common_skins = 0;  ///< rays that meet what the boxes have in common
  int cuts = 0;          ///< rays that meet the one without the other otherwise than the one
  int slivers = 0;       ///< rays not counted there: what they meet is as short as rounding

  void operator+=(const TouchTally& other) {
    rays += other.rays;
    inner_faces += other.inner_faces;
    common_skins += other.common_skins;
    cuts += other.cuts;
    slivers += other.slivers;
  }
};

template <class Real>
void try_touching(Random& random, TouchTally& tally) {
  const Place place = random_place(random);
  const Object one = cube_at(place.placement);
  const Object other = cube_at(concatenated(place.placement, trial::moved({2, 0, 0})));
  TrialScene<Real> alone(scene_of(one));
  TrialScene<Real> both(scene_of(combined(BooleanOperator::union_of, {one, other})));
  TrialScene<Real> common(scene_of(combined(BooleanOperator::intersection, {one, other})));
  TrialScene<Real> rest(scene_of(combined(BooleanOperator::difference, {one, other})));
  const Vector3 across = place.placement[0] / glm::length(place.placement[0]);
  for (int ray = 0; ray < k_rays_per_body; ++ray) {
    const Vector3 aim = firmware::transform_point(place.placement, Vector3(1, 0, 0)) +
                        random.in_cube(place.size / 2);
    const Vector3 direction = random.direction();
    if (std::fabs(glm::dot(across, direction)) < k_grazing_sine) {
      continue;
    }
    const Vector3 from = origin_of_ray(random, place, aim, direction);
    const auto query = query_of<Real>(rounded<Real>(from), direction);
    ++tally.rays;
    tally.inner_faces += both.crossings(query).count > 2 ? 1 : 0;
    const Crossings<Real> nothing = common.crossings(query);
    if (nothing.count > 0) {
      ++(is_sliver(common, query, nothing) ? tally.slivers : tally.common_skins);
    }
    const Crossings<Real> whole = alone.crossings(query);
    if (rest.crossings(query).count != whole.count) {
      ++(is_sliver(alone, query, whole) ? tally.slivers : tally.cuts);
    }
  }
}

}  // namespace

template <class Real>
std::vector<StabilityRow> coincident_solid_rows(const SolidFamily& family, int trials) {
  const auto tally = tally_over<SkinTally>(trials, [&](int number, SkinTally& sum) {
    Random random(static_cast<std::uint32_t>(number) + 6000000);
    try_without_itself<Real>(random, family, sum);
  });
  const std::string subject = family.name + " without itself";
  return {{k_group, subject, "rays", 1.0 * tally.rays, {}},
          {k_group, subject, "see a skin", 1.0 * tally.skins, std::floor(k_unlucky * tally.rays)},
          {k_group, subject, "see a skin where they graze, at edges", 1.0 * tally.uncertain, {}}};
}

template <class Real>
std::vector<StabilityRow> touching_box_rows(int trials) {
  const auto tally = tally_over<TouchTally>(trials, [&](int number, TouchTally& sum) {
    Random random(static_cast<std::uint32_t>(number) + 7000000);
    try_touching<Real>(random, sum);
  });
  const char* subject = "boxes with a common face";
  return {{k_group, subject, "rays steeper than 0.11 degrees", 1.0 * tally.rays, {}},
          {k_group, subject, "see the face in the union", 1.0 * tally.inner_faces, 0},
          {k_group, subject, "meet the intersection", 1.0 * tally.common_skins, 0},
          {k_group, subject, "find the difference cut", 1.0 * tally.cuts, 0},
          {k_group, subject, "see or miss a sliver at an edge", 1.0 * tally.slivers, {}}};
}

template std::vector<StabilityRow> coincident_solid_rows<float>(const SolidFamily&, int);
template std::vector<StabilityRow> coincident_solid_rows<double>(const SolidFamily&, int);
template std::vector<StabilityRow> touching_box_rows<float>(int);
template std::vector<StabilityRow> touching_box_rows<double>(int);

}  // namespace maquette::sim
