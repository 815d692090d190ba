#include "firmware/direct_light.hpp"

#include <memory>

#include "tests/catch.hpp"
#include "tests/firmware/facet_surface.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Random;

constexpr double k_pi = elementary::k_pi;

/// A point of a plane z = 0 as it is seen from above under an angle.
struct Scene {
  explicit Scene(const Surface<double>& surface) {
    model.surfaces = {surface};
    const NodeIndex root = model.add(kind_of<half_space::Kind>, trial::unmoved());
    built = std::make_unique<BuiltFrame<double>>(model, root);
    point.normal = {0, 0, 1};
    point.before = k_void;
    point.after = 0;
  }

  Color<double> reflected(const Vector<double>& towards_view, const Vector<double>& to_light) {
    const View<double> view = view_of(built->frame, point, -towards_view);
    return reflectance(built->frame, point, view, {to_light, 1, to_light.z});
  }

  Model model;
  std::unique_ptr<BuiltFrame<double>> built;
  SurfacePoint<double> point{};
};

Vector<double> view_at(double cosine) { return {std::sqrt(1 - cosine * cosine), 0, cosine}; }

/// Share of the light that arrives from the view's direction that leaves in any other, by a
/// quadrature over the hemisphere. By reciprocity that is what a uniformly bright sky shows.
double albedo(Scene& scene, double cosine, int steps = 100) {
  const Vector<double> view = view_at(cosine);
  Color<double> sum(0, 0, 0);
  for (int ring = 0; ring < steps; ++ring) {
    const double theta = (ring + 0.5) * (k_pi / 2) / steps;
    for (int sector = 0; sector < steps; ++sector) {
      const double phi = (sector + 0.5) * k_pi / steps;  // half: the other mirrors it
      const Vector<double> light(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                 std::cos(theta));
      sum += scene.reflected(view, light) * std::sin(theta);
    }
  }
  const double cell = (k_pi / 2 / steps) * (k_pi / steps) * 2;
  return larger(sum.x, larger(sum.y, sum.z)) * cell;
}

TEST_CASE("A matt surface reflects its diffuse share under every angle") {
  Scene scene(trial::matt_surface({0.8, 0.5, 0.2}));
  CHECK(albedo(scene, 0.9) == Approx(0.8).epsilon(1e-4));
  CHECK(albedo(scene, 0.1) == Approx(0.8).epsilon(1e-4));
}

TEST_CASE("No surface reflects more than arrives, whatever the angle") {
  for (const FacetKind facets : trial::facet_kinds()) {
    for (const double half_angle : {0.1, 0.3, 0.8}) {
      for (const double specular : {0.4, 1.0}) {
        Surface<double> plastic = trial::facet_surface(facets, half_angle);
        plastic.diffuse = {1, 1, 1};
        plastic.specular = specular;
        Surface<double> silver = plastic;
        silver.metal = true;
        silver.index = {0.05, 0.05, 0.05};
        silver.extinction = {4, 4, 4};
        Surface<double> glass = trial::facet_surface(facets, half_angle);
        glass.transparent = true;
        for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05}) {
          CAPTURE(distribution_of(facets).name, half_angle, specular, cosine);
          Scene of_plastic(plastic);
          Scene of_silver(silver);
          Scene of_glass(glass);
          CHECK(albedo(of_plastic, cosine) < 1.001);
          CHECK(albedo(of_silver, cosine) < 1.001);
          CHECK(albedo(of_glass, cosine) < 1.001);
        }
      }
    }
  }
}

TEST_CASE("A nearly smooth surface seen from above reflects what a mirror would") {
  // Trowbridge and Reitz's has so long a tail that it is not nearly smooth.
  for (const auto facets : {facet_kind_of<cosine_power::Kind>, facet_kind_of<gaussian::Kind>}) {
    Surface<double> silver = trial::facet_surface(facets, 0.03);
    silver.metal = true;
    silver.index = {0.2, 0.2, 0.2};
    silver.extinction = {3, 3, 3};
    Scene scene(silver);
    CHECK(albedo(scene, 0.99, 600) == Approx(conductor_reflection(0.99, 0.2, 3.0)).epsilon(0.02));
  }
}

TEST_CASE("Light and view may be exchanged") {
  Random random(1001);
  const Vector<double> normal(0, 0, 1);
  Surface<double> plastic = trial::facet_surface(facet_kind_of<trowbridge_reitz::Kind>, 0.3);
  plastic.specular = 0.6;
  plastic.diffuse = {0.5, 0.5, 0.5};
  Scene scene(plastic);
  for (int i = 0; i < 5000; ++i) {
    const Vector<double> a = random.direction_around(normal, random.uniform(0.02, 1));
    const Vector<double> b = random.direction_around(normal, random.uniform(0.02, 1));
    // The reflectance times the cosine of the incidence.
    REQUIRE(scene.reflected(a, b).x * a.z == Approx(scene.reflected(b, a).x * b.z).epsilon(1e-9));
  }
}

/// A stack of transparent layers below z = 0, seen from straight above.
struct Layers {
  Layers(Random& random, double light_height) {
    const int count = 1 + random.below(4);
    model.lights = {{{0, 0, light_height}, {1, 1, 1}}};
    NodeIndex root = Model::k_composite;
    double top = 0;
    for (int layer = 0; layer < count; ++layer) {
      const double bottom = top - random.uniform(0.5, 2);
      borders.push_back(top);
      const SurfaceIndex surface = model.add(trial::glass_surface(random.uniform(1.1, 2)));
      Surface<double>& glass = model.surfaces[surface];
      const FacetShape shape = cosine_power::shape(0.3);
      glass.facet_parameter = shape.parameter;
      glass.facet_scale = shape.scale;
      const NodeIndex box = model.add(kind_of<box::Kind>,
                                      concatenate(trial::moved({0, 0, (top + bottom) / 2}),
                                                  trial::scaled({5, 5, (top - bottom) / 2})),
                                      surface);
      root = layer == 0 ? box : model.combine(BooleanOperator::union_of, root, box);
      top = bottom;
    }
    borders.push_back(top);
    built = std::make_unique<BuiltFrame<double>>(model, root);
  }

  /// What passes the border below a height towards a view above it.
  double seen_through(double above) {
    const Vector<double> down(0, 0, -1);
    RayQuery<double> query{{{0, 0, above}, down}, far_away<double>(), false, 0, 0};
    const auto crossings = built->crossings_of(query);
    SurfaceIndex before = k_void;
    const std::int32_t first =
        first_ahead(crossings.data(), static_cast<std::int32_t>(crossings.size()), before);
    const SurfacePoint<double> point =
        surface_point(built->frame, query, crossings[static_cast<std::size_t>(first)], before);
    RayCounts rays{};
    return light_from(built->frame, 0, point, view_of(built->frame, point, down),
                      built->area().crossings, rays)
        .x;
  }

  Model model;
  std::vector<double> borders;
  std::unique_ptr<BuiltFrame<double>> built;
};

TEST_CASE("A source behind layers of transparent matter is seen through the border next to it") {
  Random random(1002);
  int inside = 0;
  for (int i = 0; i < 300; ++i) {
    const double height = random.uniform(-8, -0.1);
    Layers layers(random, height);
    for (std::size_t border = 0; border < layers.borders.size(); ++border) {
      const double at = layers.borders[border];
      const bool is_last = border + 1 == layers.borders.size();
      const bool is_next_to_it = at > height && (is_last || layers.borders[border + 1] < height);
      CAPTURE(i, height, at);
      // A source above the border is behind the view.
      if (at > height) {
        REQUIRE((layers.seen_through(at + 0.01) > 0) == is_next_to_it);
        inside += is_next_to_it && !is_last ? 1 : 0;
      }
    }
  }
  CHECK(inside > 30);
}

TEST_CASE("Matter between a border and a source in it takes of the light") {
  Random random(1003);
  Layers layers(random, -0.4);
  const double clear = layers.seen_through(0.1);
  const SurfaceIndex glass = 1;
  layers.model.surfaces[glass].absorbing = true;
  layers.model.surfaces[glass].absorption = {2, 2, 2};
  layers.built = std::make_unique<BuiltFrame<double>>(layers.model, layers.built->root());
  CHECK(clear > 0);
  CHECK(layers.seen_through(0.1) == Approx(clear * std::exp(-0.8)).epsilon(1e-6));
}

TEST_CASE("A grazing light in the view's back leaves numbers finite") {
  Scene scene(trial::facet_surface(facet_kind_of<gaussian::Kind>, 0.2));
  for (const double low : {0.0, 1e-300, 1e-17, 1e-9}) {
    const Vector<double> view = glm::normalize(Vector<double>(1, 0, low));
    const Vector<double> light = glm::normalize(Vector<double>(-1, 0, 1e-9));
    CHECK(std::isfinite(scene.reflected(view, light).x));
    CHECK(std::isfinite(scene.reflected(view, -view + Vector<double>(0, 0, 1e-12)).x));
  }
}

}  // namespace
}  // namespace maquette::firmware
