#include "sim/stability/extreme_solids.hpp"

#include <cmath>
#include <utility>

#include "sim/primitives/revolution.hpp"
#include "sim/stability/tally.hpp"
#include "sim/stability/trial_ray.hpp"

namespace maquette::sim {

namespace {

using trial::Random;

constexpr const char* k_group = "extreme";
constexpr int k_rays_per_solid = 20;

struct SolidTally {
  int met = 0;  ///< rays that meet the solid
  int broken = 0;
  int unsound = 0;  ///< points seen that are no numbers

  void operator+=(const SolidTally& other) {
    met += other.met;
    broken += other.broken;
    unsound += other.unsound;
  }
};

template <class Real>
bool is_finite(const firmware::Vector<Real>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Rays from near and far at random points of the cube that a solid fits in its frame.
template <class Real>
void try_solid(Random& random, TrialScene<Real>& scene, const Placement& placement, double size,
               SolidTally& tally) {
  for (int ray = 0; ray < k_rays_per_solid; ++ray) {
    const Vector3 aim = firmware::transform_point(placement, random.in_cube());
    const Vector3 direction = random.direction();
    const Vector3 from = aim - direction * (size * random.magnitude(1e-3, 30));
    const auto query = query_of<Real>(rounded<Real>(from), direction);
    tally.broken += has_parity(scene.crossings(query)) ? 0 : 1;
    const FirstAhead<Real> found = first_ahead(scene, query);
    if (found.is_met && found.crossing.distance < firmware::far_away<Real>()) {
      const auto point =
          firmware::surface_point(scene.frame(), query, found.crossing, found.before);
      ++tally.met;
      tally.unsound += is_finite(point.position) && is_finite(point.normal) ? 0 : 1;
    }
  }
}

std::vector<StabilityRow> rows_of(const std::string& subject, const SolidTally& tally) {
  return {{k_group, subject, "rays that meet it", 1.0 * tally.met, {}},
          {k_group, subject, "in/out parity broken", 1.0 * tally.broken, 0},
          {k_group, subject, "points or normals that are no numbers", 1.0 * tally.unsound, 0}};
}

Object revolved(std::vector<glm::dvec2> points, bool closed) {
  Object object;
  object.surface = k_trial_surfaces[0];
  object.primitive = primitive_of(RevolutionShape{std::move(points), closed, {}});
  return object;
}

struct Generatrix {
  const char* name;
  std::vector<glm::dvec2> points;
  bool closed;
};

const std::vector<Generatrix>& extreme_generatrices() {
  static const std::vector<Generatrix> all{
      {"touches the axis at both ends",
       {{-0.4, -1}, {0, -1}, {0.4, -1}, {0.8, 0}, {0.4, 1}, {0, 1}, {-0.4, 1}},
       false},
      {"touches the axis between",
       {{0.5, -1},
        {0.5, -0.8},
        {0.25, -0.3},
        {0, 0},
        {0, 0},
        {0, 0},
        {0.25, 0.3},
        {0.5, 0.8},
        {0.5, 1}},
       false},
      {"runs along the axis",
       {{0.5, -1},
        {0.5, -1},
        {0.3, -0.5},
        {0, -0.2},
        {0, 0},
        {0, 0.1},
        {0, 0.2},
        {0.3, 0.5},
        {0.5, 1}},
       false},
      {"horizontal parts",
       {{0.9, -1},
        {0.9, -1},
        {0.9, -1},
        {0.9, 0},
        {0.9, 0},
        {0.9, 0},
        {0.5, 0},
        {0.3, 0},
        {0.3, 0},
        {0.3, 0},
        {0.3, 1},
        {0.3, 1},
        {0.3, 1}},
       false},
      {"closed", {{0.4, -0.5}, {0.9, -0.5}, {0.9, 0.5}, {0.4, 0.5}}, true},
      {"closed, a triangle with straight sides",
       {{0.3, 0},
        {0.3, 0},
        {0.3, 0},
        {0.9, 0},
        {0.9, 0},
        {0.9, 0},
        {0.6, 0.5},
        {0.6, 0.5},
        {0.6, 0.5}},
       true},
      {"sections that are a point",
       {{0.6, -1}, {0.6, 0}, {0.6, 0}, {0.6, 0}, {0.6, 0}, {0.6, 0}, {0.3, 1}, {0.3, 1.5}},
       false},
      {"1e-6 thin",
       {{0.9, -1},
        {0.9, -1},
        {0.9, -1},
        {0.9, 1},
        {0.9, 1},
        {0.9, 1},
        {0.899999, 1},
        {0.899999, 1},
        {0.899999, 1},
        {0.899999, -1},
        {0.899999, -1},
        {0.899999, -1}},
       true},
      {"1e-6 high", {{0.3, 0}, {0.6, 0}, {0.6, 1e-6}, {0.3, 1e-6}}, true}};
  return all;
}

}  // namespace

template <class Real>
std::vector<StabilityRow> stretched_solid_rows(const SolidFamily& family, int trials) {
  const auto tally = tally_over<SolidTally>(trials, [&](int number, SolidTally& sum) {
    Random random(static_cast<std::uint32_t>(number) + 8000000);
    const double size = random.magnitude(1e-2, 1e2);
    const Vector3 center = random.direction() * (size * random.magnitude(1e-3, 10));
    const Placement placement = random.placement(center, size, 1e6);
    TrialScene<Real> scene(scene_of(random_solid(random, family, placement)));
    try_solid(random, scene, placement, size, sum);
  });
  return rows_of(family.name + ", axes differing by up to 1e6", tally);
}

template <class Real>
std::vector<StabilityRow> extreme_generatrix_rows(int trials) {
  std::vector<StabilityRow> rows;
  std::uint32_t seed = 9000000;
  for (const Generatrix& generatrix : extreme_generatrices()) {
    Object solid = revolved(generatrix.points, generatrix.closed);
    const auto tally = tally_over<SolidTally>(trials, [&](int number, SolidTally& sum) {
      Random random(seed + static_cast<std::uint32_t>(number));
      const double size = random.magnitude(1e-2, 1e2);
      const Vector3 center = random.direction() * (size * random.magnitude(1e-3, 10));
      Object placed = solid;
      placed.placement = random.placement(center, size, 3);
      TrialScene<Real> scene(scene_of(placed));
      try_solid(random, scene, placed.placement, size, sum);
    });
    seed += 100000;
    for (StabilityRow& row : rows_of(std::string("generatrix: ") + generatrix.name, tally)) {
      rows.push_back(std::move(row));
    }
  }
  return rows;
}

template std::vector<StabilityRow> stretched_solid_rows<float>(const SolidFamily&, int);
template std::vector<StabilityRow> stretched_solid_rows<double>(const SolidFamily&, int);
template std::vector<StabilityRow> extreme_generatrix_rows<float>(int);
template std::vector<StabilityRow> extreme_generatrix_rows<double>(int);

}  // namespace maquette::sim
