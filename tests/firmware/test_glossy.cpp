#include "firmware/glossy.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/facet_surface.hpp"

namespace maquette::firmware {
namespace {

using trial::Random;

constexpr double k_pi = elementary::k_pi;

Vector<double> view_at(double cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

SurfacePoint<double> point_of_plane() {
  SurfacePoint<double> point{};
  point.normal = {0, 0, 1};
  return point;
}

View<double> view_of_border(double cosine, double index) {
  return {view_at(cosine), cosine, index, false};
}

/// Sum of a function of unit vectors above the plane over their solid angle.
template <class Function>
double over_hemisphere(int steps, Function value) {
  double sum = 0;
  for (int ring = 0; ring < steps; ++ring) {
    // Rings crowd near the pole, where narrow lobes are.
    const double root = (ring + 0.5) / steps;
    const double theta = k_pi / 2 * root * root;
    const double ring_width = k_pi * root / steps;
    for (int sector = 0; sector < steps; ++sector) {
      const double phi = (sector + 0.5) * k_pi / steps;  // half: the other mirrors it
      const Vector<double> direction(std::sin(theta) * std::cos(phi),
                                     std::sin(theta) * std::sin(phi), std::cos(theta));
      sum += value(direction) * std::sin(theta) * ring_width;
    }
  }
  return sum * 2 * k_pi / steps;
}

/// The density of the facets' normals per solid angle and area of the surface.
double density(const Surface<double>& surface, double cosine) {
  return 4 / k_pi * facet_distribution(surface, cosine);
}

/// The direction of light that a facet bends into a view, 0 0 0 where none is.
Vector<double> refracted(const Vector<double>& view, const Vector<double>& half, double index) {
  const double cosine = glm::dot(view, half);
  const double sine_squared = (1 - cosine * cosine) / (index * index);
  if (!(cosine > 0) || sine_squared >= 1) {
    return {0, 0, 0};
  }
  return half * (cosine / index - std::sqrt(1 - sine_squared)) - view / index;
}

/// What all facets that a view meets send into it of a uniformly bright surrounding: each counts by
/// its area across the view.
double let_through_by_facets(const Surface<double>& glass, double cosine, double index) {
  const Vector<double> view = view_at(cosine);
  return over_hemisphere(400, [&](const Vector<double>& half) {
    const double v_h = glm::dot(view, half);
    const Vector<double> light = refracted(view, half, index);
    if (!(v_h > 1e-9) || !(light.z < 0)) {
      return 0.0;
    }
    const double l_h = -glm::dot(light, half);
    return (1 - dielectric_border(v_h, index).reflected) * density(glass, half.z) *
           facet_attenuation(half.z, cosine, -light.z, v_h, l_h) * v_h / cosine;
  });
}

double reflected_by_facets(const Surface<double>& glass, double cosine, double index) {
  const Vector<double> view = view_at(cosine);
  return over_hemisphere(400, [&](const Vector<double>& half) {
    const double v_h = glm::dot(view, half);
    const Vector<double> light = half * (2 * v_h) - view;
    if (!(v_h > 1e-9) || !(light.z > 0)) {
      return 0.0;
    }
    return dielectric_border(v_h, index).reflected * density(glass, half.z) *
           facet_attenuation(half.z, cosine, light.z, v_h) * v_h / cosine;
  });
}

double let_through(const Surface<double>& glass, double cosine, double index) {
  const View<double> view = view_of_border(cosine, index);
  return over_hemisphere(400, [&](const Vector<double>& up) {
    return glossy_transmission(glass, point_of_plane(), view, {up.x, up.y, -up.z}, up.z);
  });
}

double reflected(const Surface<double>& glass, double cosine, double index) {
  const View<double> view = view_of_border(cosine, index);
  return over_hemisphere(400, [&](const Vector<double>& up) {
    return glossy_reflection(glass, point_of_plane(), view, up, up.z).x;
  });
}

TEST_CASE("A rough border sends into a view what its facets do, one by one") {
  for (const FacetKind facets : trial::facet_kinds()) {
    for (const double half_angle : {0.15, 0.5}) {
      const Surface<double> glass = trial::facet_surface(facets, half_angle);
      for (const double index : {1 / 2.4, 1 / 1.5, 1.33, 1.8}) {
        for (const double cosine : {1.0, 0.7, 0.4}) {
          CAPTURE(distribution_of(facets).name, half_angle, index, cosine);
          CHECK(let_through(glass, cosine, index) ==
                Approx(let_through_by_facets(glass, cosine, index)).epsilon(0.01).margin(0.002));
          CHECK(reflected(glass, cosine, index) ==
                Approx(reflected_by_facets(glass, cosine, index)).epsilon(0.01).margin(0.002));
        }
      }
    }
  }
}

TEST_CASE("A nearly smooth border reflects F and lets 1 - F through") {
  for (const auto facets : {facet_kind_of<cosine_power::Kind>, facet_kind_of<gaussian::Kind>}) {
    const Surface<double> glass = trial::facet_surface(facets, 0.04);
    for (const double index : {1 / 1.5, 1 / 1.2, 1.2, 1.5, 2.4}) {
      for (const double cosine : {1.0, 0.95, 0.88}) {
        CAPTURE(distribution_of(facets).name, index, cosine);
        const double share = dielectric_border(cosine, index).reflected;
        CHECK(let_through(glass, cosine, index) == Approx(1 - share).epsilon(0.02));
        CHECK(reflected(glass, cosine, index) == Approx(share).epsilon(0.05));
      }
    }
  }
}

TEST_CASE("What a rough border reflects and lets through is no more than arrives") {
  for (const FacetKind facets : trial::facet_kinds()) {
    for (const double index : {1 / 1.05, 1 / 1.5, 1 / 2.4, 1.0, 1.5}) {
      for (const double half_angle : {0.1, 0.4}) {
        const auto glass = trial::facet_surface(facets, half_angle);
        for (const double cosine : {1.0, 0.6, 0.1}) {
          CAPTURE(distribution_of(facets).name, index, half_angle, cosine);
          const double back = reflected(glass, cosine, index);
          const double through = let_through(glass, cosine, index);
          CHECK(back >= 0);
          CHECK(through >= 0);
          CHECK(back + through < 1.01);
        }
      }
    }
  }
}

TEST_CASE("Light goes both ways through a rough border alike") {
  Random random(1004);
  const SurfacePoint<double> point = point_of_plane();
  int bent = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto facets = static_cast<FacetKind>(random.below(k_facet_kind_count));
    const Surface<double> glass = trial::facet_surface(facets, random.uniform(0.1, 0.8));
    const double index = random.magnitude(0.4, 2.5);
    const Vector<double> above = random.direction_around({0, 0, 1}, random.uniform(0.05, 1));
    const Vector<double> below = random.direction_around({0, 0, -1}, random.uniform(0.05, 1));
    const double down =
        glossy_transmission(glass, point, {above, above.z, index, false}, below, -below.z);
    // The same from the other side: a turned surface.
    SurfacePoint<double> turned = point;
    turned.normal = {0, 0, -1};
    const double up =
        glossy_transmission(glass, turned, {below, -below.z, 1 / index, false}, above, above.z);
    // Without the cosine of the incidence, per square of the index on the light's side.
    REQUIRE(down / -below.z / (index * index) == Approx(up / above.z).epsilon(1e-6).margin(1e-12));
    bent += down > 0 ? 1 : 0;
  }
  CHECK(bent > 1000);
}

TEST_CASE("Between equal indices no facet bends light") {
  Random random(1005);
  const Surface<double> glass = trial::facet_surface(facet_kind_of<gaussian::Kind>, 0.3);
  for (int i = 0; i < 1000; ++i) {
    const Vector<double> above = random.direction_around({0, 0, 1}, random.uniform(0.05, 1));
    const Vector<double> below = random.direction_around({0, 0, -1}, random.uniform(0.05, 1));
    REQUIRE(glossy_transmission(glass, point_of_plane(), {above, above.z, 1.0, false}, below,
                                -below.z) == 0);
  }
}

TEST_CASE("A metal counts against the matter in front of it") {
  Random random(1006);
  Surface<double> metal = trial::mirror_surface();
  for (int i = 0; i < 1000; ++i) {
    const double medium = random.uniform(0.5, 3);
    const double cosine = random.uniform(0.01, 1);
    Surface<double> within = metal;
    within.index = metal.index * medium;
    within.extinction = metal.extinction * medium;
    const Color<double> alone = fresnel_factor(metal, cosine, view_of_border(cosine, 1));
    const Color<double> inside =
        fresnel_factor(within, cosine, {view_at(cosine), cosine, medium, true});
    REQUIRE(inside.x == Approx(alone.x).epsilon(1e-9));
    REQUIRE(inside.z == Approx(alone.z).epsilon(1e-9));
    // A conductor that does not conduct, of the index around it, is not seen.
    within.index = {medium, medium, medium};
    within.extinction = {0, 0, 0};
    REQUIRE(fresnel_factor(within, cosine, {view_at(cosine), cosine, medium, true}).y ==
            Approx(0).margin(1e-9));
  }
}

TEST_CASE("A view from within glass takes the metal's index against the glass") {
  trial::Model model;
  const SurfaceIndex glass = model.add(trial::glass_surface(1.7));
  const SurfaceIndex silver = model.add(trial::mirror_surface());
  const NodeIndex root = model.add(kind_of<half_space::Kind>, trial::unmoved());
  trial::BuiltFrame<double> built(model, root);
  SurfacePoint<double> point = point_of_plane();
  point.surface = point.after = silver;
  point.before = k_void;
  CHECK(view_of(built.frame, point, {0, 0, -1}).index == 1);
  CHECK_FALSE(view_of(built.frame, point, {0, 0, -1}).is_in_matter);
  point.before = glass;
  CHECK(view_of(built.frame, point, {0, 0, -1}).index == Approx(1.7));
  CHECK(view_of(built.frame, point, {0, 0, -1}).is_in_matter);
}

}  // namespace
}  // namespace maquette::firmware
