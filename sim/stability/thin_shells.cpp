#include "sim/stability/thin_shells.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/scene/placement.hpp"
#include "sim/stability/random_tree.hpp"
#include "sim/stability/tally.hpp"
#include "sim/stability/trial_scene.hpp"

namespace maquette::sim {

namespace {

using trial::Random;

constexpr int k_rays_per_shell = 20;
/// Walls thicker than this many times the distance within which crossings are taken as one.
constexpr double k_safety = 2;

struct ShellTally {
  int walls = 0;
  int lost = 0;

  void operator+=(const ShellTally& other) {
    walls += other.walls;
    lost += other.lost;
  }
};

/// Distance across faces within which the firmware takes crossings with these leaves as one.
template <class Real>
double merging_distance(const firmware::Frame<Real>& frame, double distance) {
  const auto scale = static_cast<double>(frame.prepared.leaves[0].scale) +
                     static_cast<double>(frame.prepared.leaves[1].scale);
  return (scale + distance) *
         static_cast<double>(firmware::ulps<Real>(firmware::preprocessing::k_crossing_tolerance));
}

template <class Real>
void try_ray(TrialScene<Real>& shell, TrialScene<double>& outer, const Vector3& center,
             const Vector3& direction, double way, double thickness, ShellTally& tally) {
  const auto query = query_of<double>(center - direction * way, direction);
  const Crossings<double> whole = outer.crossings(query);
  if (whole.count != 2) {
    return;
  }
  const auto cosine = [&](const firmware::Crossing<double>& crossing) {
    return std::fabs(
        glm::dot(firmware::face_point(outer.frame(), query, crossing).normal, direction));
  };
  // From the middle a wall begins at 1 - thickness of the way to the surface.
  const double near_wall = (way - whole.first[0].distance) * thickness * cosine(whole.first[0]);
  const double far_wall = (whole.first[1].distance - way) * thickness * cosine(whole.first[1]);
  const double least =
      k_safety * merging_distance(shell.frame(), static_cast<double>(whole.first[1].distance));
  const auto same = query_of<Real>(rounded<Real>(query.ray.origin), direction);
  const int missing = (4 - shell.crossings(same).count) / 2;
  if (near_wall > least && far_wall > least) {
    tally.walls += 2;
    tally.lost += std::abs(missing);
  }
}

template <class Real>
void try_shell(Random& random, const SolidFamily& family, double thickness, ShellTally& tally) {
  const double size = random.magnitude(1e-4, 1e4);
  const Vector3 center = random.direction() * (size * random.magnitude(1e-3, 10));
  const Placement placement = random.placement(center, size, 3);
  const double inner = 1 - thickness;
  const Object outer = random_solid(random, family, placement);
  Object core = outer;
  core.placement =
      concatenated(placement, concatenated(trial::scaled({inner, inner, inner}),
                                           concatenated(inverse_of(placement), outer.placement)));
  TrialScene<double> whole(scene_of(outer));
  TrialScene<Real> shell(scene_of(combined(firmware::BooleanOperator::difference, {outer, core})));
  for (int ray = 0; ray < k_rays_per_shell; ++ray) {
    const double way = size * random.magnitude(3, 30);
    try_ray(shell, whole, center, random.direction(), way, thickness, tally);
  }
}

std::vector<const SolidFamily*> convex_families(const std::vector<SolidFamily>& families) {
  std::vector<const SolidFamily*> convex;
  for (const SolidFamily& family : families) {
    if (family.is_bounded && firmware::primitive_of<double>(family.kind).is_convex) {
      convex.push_back(&family);
    }
  }
  return convex;
}

}  // namespace

template <class Real>
std::vector<StabilityRow> thin_shell_rows(const std::vector<SolidFamily>& families, int trials) {
  const std::vector<const SolidFamily*> convex = convex_families(families);
  std::vector<StabilityRow> rows;
  std::uint32_t seed = 4000000;
  for (const double thickness : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const auto tally = tally_over<ShellTally>(trials, [&](int number, ShellTally& sum) {
      Random random(seed + static_cast<std::uint32_t>(number));
      try_shell<Real>(random, *convex[static_cast<std::size_t>(number) % convex.size()], thickness,
                      sum);
    });
    seed += 100000;
    const std::string subject = fmt::format("shells of {:g} of the size", thickness);
    rows.push_back({"csg", subject, "walls thicker than rounding", 1.0 * tally.walls, {}});
    rows.push_back({"csg", subject, "of them, lost", 1.0 * tally.lost, 0});
  }
  return rows;
}

template std::vector<StabilityRow> thin_shell_rows<float>(const std::vector<SolidFamily>&, int);
template std::vector<StabilityRow> thin_shell_rows<double>(const std::vector<SolidFamily>&, int);

}  // namespace maquette::sim
