#include "sim/stability/secondary_rays.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "sim/stability/tally.hpp"
#include "sim/stability/trial_ray.hpp"

namespace maquette::sim {

namespace {

using firmware::RayQuery;
using firmware::SurfacePoint;
using trial::Random;

constexpr int k_rays_per_trial = 8;
constexpr double k_axis_ratio = 10;
/// Spacings of the coordinates by which rounding may move a ray, generously.
constexpr double k_ray_rounding = 64;
/// A ray leaves a surface one clearance off it. A crossing within so many is of what it left.
constexpr double k_near_clearances = 4;
/// So many clearances off the surface nothing else may be nearer for a ray to count: near edges and
/// where the solid is no larger than its coordinates are known, no side is certain.
constexpr double k_room_clearances = 8;
constexpr double k_room_share = 0.9;
constexpr double k_start_share = 0.5;

struct RayTally {
  int aimed = 0;   ///< rays whose aim lies deeper inside than rounding reaches
  int passed = 0;  ///< of them, those that find no matter there
  int left = 0;    ///< rays that leave outwards
  int met_again = 0;
  int entered = 0;   ///< rays inwards, of points where the matter is thick enough
  int fell_out = 0;  ///< of them, those that start outside
  int without_normal = 0;

  void operator+=(const RayTally& other) {
    aimed += other.aimed;
    passed += other.passed;
    left += other.left;
    met_again += other.met_again;
    entered += other.entered;
    fell_out += other.fell_out;
    without_normal += other.without_normal;
  }
};

/// A solid somewhere, in the number type that is tried and in double precision.
template <class Real>
struct Trial {
  explicit Trial(const Scene& scene) : tried(scene), reference(scene) {}

  TrialScene<Real> tried;
  TrialScene<double> reference;
};

/// A direction away from a surface, often a grazing one.
Vector3 leaving_direction(Random& random, const Vector3& normal) {
  const double cosine = random.coin() ? random.uniform(0.01, 1) : random.magnitude(1e-6, 0.1);
  return random.direction_around(glm::normalize(normal), cosine);
}

/// Whether a point so many clearances off the surface, inside or outside, is there for certain: no
/// surface is nearer than a share of them.
template <class Real>
bool is_clear(Random& random, Trial<Real>& trial, const SurfacePoint<Real>& point,
              double clearances, double share) {
  const auto clearance = static_cast<double>(point.clearance);
  const Surroundings found =
      surroundings_of(random, trial.reference,
                      Vector3(point.position) + Vector3(point.normal) * (clearances * clearance));
  return found.is_inside == (clearances < 0) &&
         found.distance >= share * std::fabs(clearances) * clearance;
}

/// Whether a point of the surface has room on a side, 1 outside and -1 inside: away from edges,
/// from where a ray starts to well behind.
template <class Real>
bool has_room(Random& random, Trial<Real>& trial, const SurfacePoint<Real>& point, int side) {
  return is_clear(random, trial, point, side * k_room_clearances, k_room_share) &&
         is_clear(random, trial, point, side, k_start_share);
}

/// What the reference finds on the ray that was tried; nothing where nothing stronger than the
/// number type is there.
template <class Real>
std::optional<FirstAhead<double>> reference_of(Trial<Real>& trial, const RayQuery<Real>& query) {
  if constexpr (std::is_same_v<Real, double>) {
    return std::nullopt;
  } else {
    return first_ahead(trial.reference,
                       query_of<double>(Vector3(query.ray.origin), Vector3(query.ray.direction)));
  }
}

/// Whether a ray meets what it has left: it starts inside, or a surface is very near. In a hollow
/// as small as the rounding of single precision that is right, and the reference finds the same.
template <class Real>
bool meets_again(Trial<Real>& trial, const RayQuery<Real>& query, Real near) {
  const auto meets = [](const auto& found, auto distance) {
    return found.before != firmware::k_void || (found.is_met && found.crossing.distance < distance);
  };
  if (!meets(first_ahead(trial.tried, query), near)) {
    return false;
  }
  const auto reference = reference_of(trial, query);
  return !reference || !meets(*reference, 2 * static_cast<double>(near));
}

/// Whether the reference is certain that a ray starts inside: moved by what rounding may, it still
/// does, and leaves the solid no sooner than `near`.
bool starts_inside(TrialScene<double>& reference, const Vector3& from, const Vector3& direction,
                   double rounding, double near) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double aside : {-rounding, rounding}) {
      Vector3 moved = from;
      moved[axis] += aside;
      const FirstAhead<double> found = first_ahead(reference, query_of<double>(moved, direction));
      if (found.before == firmware::k_void || found.crossing.distance < near) {
        return false;
      }
    }
  }
  return true;
}

/// Whether a ray into the solid starts outside of it, and the reference knows better.
template <class Real>
bool falls_out(Trial<Real>& trial, const RayQuery<Real>& query, Real near) {
  if (first_ahead(trial.tried, query).before != firmware::k_void) {
    return false;
  }
  if constexpr (std::is_same_v<Real, double>) {
    return true;
  } else {
    constexpr double k_rounding_share = 0.25 / k_near_clearances;
    return starts_inside(trial.reference, Vector3(query.ray.origin), Vector3(query.ray.direction),
                         k_rounding_share * static_cast<double>(near), static_cast<double>(near));
  }
}

template <class Real>
Real near_of(const SurfacePoint<Real>& point) {
  return point.clearance * static_cast<Real>(k_near_clearances);
}

template <class Real>
void try_outwards(Random& random, Trial<Real>& trial, const SurfacePoint<Real>& point,
                  RayTally& tally) {
  RayQuery<Real> query =
      query_of<Real>(firmware::departure(point), leaving_direction(random, Vector3(point.normal)));
  query.left_behind = firmware::left_behind(point);
  ++tally.left;
  tally.met_again += meets_again(trial, query, near_of(point)) ? 1 : 0;
}

template <class Real>
void try_inwards(Random& random, Trial<Real>& trial, const SurfacePoint<Real>& point,
                 RayTally& tally) {
  const RayQuery<Real> query = query_of<Real>(firmware::far_departure(point),
                                              -leaving_direction(random, Vector3(point.normal)));
  ++tally.entered;
  tally.fell_out += falls_out(trial, query, near_of(point)) ? 1 : 0;
}

template <class Real>
void try_ray(Random& random, Trial<Real>& trial, const Placement& placement, RayTally& tally) {
  const Vector3 aim = firmware::transform_point(placement, random.in_cube());
  const Surroundings around = surroundings_of(random, trial.reference, aim);
  if (!around.is_inside) {
    return;
  }
  const double way = random.magnitude(1e-8, 1e8);
  const Vector3 direction = random.direction();
  const RayQuery<Real> query = query_of<Real>(rounded<Real>(aim - direction * way), direction);
  const auto scale = static_cast<double>(trial.tried.frame().prepared.leaves[0].scale);
  const double rounding = k_ray_rounding * std::numeric_limits<Real>::epsilon() * (scale + way);
  if (rounding * k_axis_ratio < around.distance) {
    ++tally.aimed;
    tally.passed += trial.tried.medium(query, static_cast<Real>(way)) == firmware::k_void ? 1 : 0;
  }
  const FirstAhead<Real> found = first_ahead(trial.tried, query);
  if (found.is_met && found.before == firmware::k_void) {
    const SurfacePoint<Real> point =
        firmware::surface_point(trial.tried.frame(), query, found.crossing, found.before);
    if (!(firmware::magnitude(point.normal) > 0)) {
      ++tally.without_normal;
      return;
    }
    if (has_room(random, trial, point, 1)) {
      try_outwards(random, trial, point, tally);
    }
    if (has_room(random, trial, point, -1)) {
      try_inwards(random, trial, point, tally);
    }
  }
}

}  // namespace

template <class Real>
std::vector<StabilityRow> secondary_ray_rows(const SolidFamily& family, int trials) {
  const auto tally = tally_over<RayTally>(trials, [&](int number, RayTally& sum) {
    Random random(static_cast<std::uint32_t>(number) + 2000000);
    const double size = random.magnitude(1e-4, 1e4);
    const Vector3 center = random.direction() * (size * random.magnitude(1e-6, 1e4));
    const Placement placement = random.placement(center, size, k_axis_ratio);
    Trial<Real> trial(scene_of(random_solid(random, family, placement)));
    for (int ray = 0; ray < k_rays_per_trial; ++ray) {
      try_ray(random, trial, placement, sum);
    }
  });
  const char* group = "secondary_rays";
  return {{group, family.name, "rays leaving a surface", 1.0 * tally.left, {}},
          {group, family.name, "met again at once (acne)", 1.0 * tally.met_again, 0},
          {group, family.name, "rays into the solid", 1.0 * tally.entered, {}},
          {group, family.name, "started outside (leaks)", 1.0 * tally.fell_out, 0},
          {group, family.name, "rays aimed at the inside", 1.0 * tally.aimed, {}},
          {group, family.name, "passed through (lost hits)", 1.0 * tally.passed, 0},
          {group,
           family.name,
           "points without a normal, from too far off to know them",
           1.0 * tally.without_normal,
           {}}};
}

template std::vector<StabilityRow> secondary_ray_rows<float>(const SolidFamily& family, int trials);
template std::vector<StabilityRow> secondary_ray_rows<double>(const SolidFamily& family,
                                                              int trials);

}  // namespace maquette::sim
