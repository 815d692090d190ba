#include "sim/stability/ray_parity.hpp"

#include <cmath>

#include "sim/stability/random_tree.hpp"
#include "sim/stability/tally.hpp"
#include "sim/stability/trial_ray.hpp"

namespace maquette::sim {

namespace {

using trial::Random;

constexpr int k_rays_per_tree = 50;
constexpr int k_points_per_tree = 10;
constexpr int k_most_solids = 12;
/// A surface nearer than this share of the tree leaves a point undecided.
constexpr double k_margin = 1e-3;

struct ParityTally {
  int rays = 0;
  int broken = 0;
  int points = 0;
  int undecided = 0;
  int in_dispute = 0;

  void operator+=(const ParityTally& other) {
    rays += other.rays;
    broken += other.broken;
    points += other.points;
    undecided += other.undecided;
    in_dispute += other.in_dispute;
  }
};

/// The side on which a point lies, by one line: of matter, void, or nothing when a surface is near.
enum class Side { outside, inside, undecided };

template <class Real>
Side side_of(Random& random, TrialScene<Real>& scene, const Vector3& point, double margin) {
  firmware::SurfaceIndex medium = firmware::k_void;
  for (const firmware::Crossing<Real>& crossing :
       scene.crossings(query_of<Real>(rounded<Real>(point), random.direction()))) {
    if (std::fabs(static_cast<double>(crossing.distance)) < margin) {
      return Side::undecided;
    }
    medium = crossing.distance > 0 ? medium : crossing.medium;
  }
  return medium == firmware::k_void ? Side::outside : Side::inside;
}

template <class Real>
void try_tree(Random& random, const std::vector<SolidFamily>& families, ParityTally& tally) {
  const double spread = random.magnitude(1e-4, 1e4);
  const Vector3 center = random.direction() * (spread * random.magnitude(1e-3, 10));
  TrialScene<Real> scene(
      scene_of(random_tree(random, families, 1 + random.below(k_most_solids), center, spread)));
  for (int ray = 0; ray < k_rays_per_tree; ++ray) {
    const Vector3 aim = center + random.in_cube(spread / 2);
    const Vector3 direction = random.direction();
    const Vector3 from = aim - direction * (spread * random.magnitude(1e-3, 30));
    ++tally.rays;
    tally.broken +=
        has_parity(scene.crossings(query_of<Real>(rounded<Real>(from), direction))) ? 0 : 1;
  }
  for (int i = 0; i < k_points_per_tree; ++i) {
    const Vector3 point = center + random.in_cube(spread / 2);
    const Side one = side_of(random, scene, point, spread * k_margin);
    const Side other = side_of(random, scene, point, spread * k_margin);
    const bool decided = one != Side::undecided && other != Side::undecided;
    ++tally.points;
    tally.undecided += decided ? 0 : 1;
    tally.in_dispute += decided && one != other ? 1 : 0;
  }
}

}  // namespace

template <class Real>
std::vector<StabilityRow> ray_parity_rows(const std::vector<SolidFamily>& families, int trees) {
  const auto tally = tally_over<ParityTally>(trees, [&](int tree, ParityTally& sum) {
    Random random(static_cast<std::uint32_t>(tree) + 3000000);
    try_tree<Real>(random, families, sum);
  });
  const char* group = "csg";
  return {
      {group, "random trees", "rays", 1.0 * tally.rays, {}},
      {group, "random trees", "in/out parity broken", 1.0 * tally.broken, 0},
      {group,
       "random trees",
       "points off every surface",
       1.0 * (tally.points - tally.undecided),
       {}},
      {group, "random trees", "inside on one line, outside on another", 1.0 * tally.in_dispute, 0}};
}

template std::vector<StabilityRow> ray_parity_rows<float>(const std::vector<SolidFamily>&, int);
template std::vector<StabilityRow> ray_parity_rows<double>(const std::vector<SolidFamily>&, int);

}  // namespace maquette::sim
