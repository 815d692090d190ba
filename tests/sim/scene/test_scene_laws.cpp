#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>

#include "firmware/arithmetic/counted.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/primitives/algebraic.hpp"
#include "sim/primitives/box.hpp"
#include "sim/primitives/cone.hpp"
#include "sim/primitives/cylinder.hpp"
#include "sim/primitives/half_space.hpp"
#include "sim/primitives/prism.hpp"
#include "sim/primitives/sphere.hpp"
#include "sim/stability/scene_scale.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

/// Laws that whole pictures keep.
namespace maquette::sim {
namespace {

constexpr PictureFormat k_size{96, 72};

template <class Shape>
Object primitive(const Shape& shape, const std::string& surface, const Vector3& at) {
  Object object;
  object.primitive = primitive_of(shape);
  object.surface = surface;
  object.placement[3] = at;
  return object;
}

Object composite(firmware::BooleanOperator combination, std::vector<Object> children) {
  Object object;
  object.combination = combination;
  object.children = std::move(children);
  return object;
}

std::vector<Surface> all_surfaces() {
  std::vector<Surface> surfaces(4);
  surfaces[0].name = "chalk";
  surfaces[0].diffuse = {0.8, 0.7, 0.6};
  surfaces[1].name = "plastic";
  surfaces[1].diffuse = {0.2, 0.4, 0.8};
  surfaces[1].specular = 0.3;
  surfaces[1].facets = firmware::facet_kind_of<firmware::gaussian::Kind>;
  surfaces[2].name = "silver";
  surfaces[2].specular = 1;
  surfaces[2].metal = true;
  surfaces[2].index = {0.2, 0.3, 0.4};
  surfaces[2].extinction = {3, 3, 3};
  surfaces[2].facets = firmware::facet_kind_of<firmware::trowbridge_reitz::Kind>;
  surfaces[3].name = "glass";
  surfaces[3].specular = 1;
  surfaces[3].transparent = true;
  surfaces[3].absorption = {0.1, 0.3, 0.05};
  surfaces[0].ambient = Color(0.1, 0.2, 0.3);
  surfaces[0].texture = Texture{};
  surfaces[0].texture->pattern = firmware::texture_kind_of<firmware::rings::Kind>;
  surfaces[0].texture->color = {0.3, 0.2, 0.1};
  surfaces[0].texture->size = 0.25;
  surfaces[0].texture->frame = TextureFrame::primitive;
  surfaces[0].texture->placement = Placement(1.0);
  return surfaces;
}

/// A torus.
Object ring(const std::string& surface, const Vector3& at) {
  AlgebraicShape shape;
  shape.size = {1.9, 1.9, 0.6};
  shape.terms = {{{4, 0, 0}, 1},   {{0, 4, 0}, 1},     {{0, 0, 4}, 1},    {{2, 2, 0}, 2},
                 {{2, 0, 2}, 2},   {{0, 2, 2}, 2},     {{2, 0, 0}, -0.9}, {{0, 2, 0}, -0.9},
                 {{0, 0, 2}, 0.7}, {{0, 0, 0}, 0.1225}};
  return primitive(shape, surface, at);
}

/// A triangle with a round hole.
Object washer(const std::string& surface, const Vector3& at) {
  PrismShape shape;
  shape.height = 0.7;
  shape.contours = {{{{-0.9, -0.6}, {0.9, -0.6}, {0, 0.9}}, false},
                    {{{-0.3, -0.3}, {0.3, -0.3}, {0.3, 0.3}, {-0.3, 0.3}}, true}};
  return primitive(shape, surface, at);
}

/// Every primitive, every operator, every kind of surface, on a ground.
Scene lively_scene() {
  Scene scene;
  scene.view.eye = {1, -11, 4.5};
  scene.view.target = {0, 0, 0.7};
  scene.view.up = {0, 0, 1};
  scene.view.field_of_view_deg = 40;
  scene.lights = {{"key", {6, -9, 12}, {0.8, 0.8, 0.7}, {}, {}, {}},
                  {"fill", {-9, -5, 6}, {0.3, 0.3, 0.4}, 9.0, Spot{{0, 0, 0}, 20, 9}, {}}};
  scene.ambient = {0.15, 0.15, 0.15};
  scene.background = {0.1, 0.2, 0.4};
  scene.surfaces = all_surfaces();
  const Object tube = primitive(CylinderShape{1, 2.2}, "plastic", {-3.1, 0.4, 0});
  const Object bore = primitive(CylinderShape{0.6, 2.2}, "chalk", {-3.1, 0.4, 0});
  const Object cone = primitive(ConeShape{1, 0, 2}, "chalk", {3, 1, 0});
  const Object bucket = primitive(ConeShape{0.4, 0.8, 1}, "silver", {1.3, -2.5, 0});
  scene.object =
      composite(firmware::BooleanOperator::union_of,
                {primitive(HalfSpaceShape{}, "chalk", {0, 0, 0}),
                 composite(firmware::BooleanOperator::difference, {tube, bore}), cone, bucket,
                 primitive(SphereShape{{1.3, 1.3, 1.3}}, "silver", {0.2, 2.5, 1.3}),
                 composite(firmware::BooleanOperator::intersection,
                           {primitive(BoxShape{{1.4, 1.4, 1.4}}, "plastic", {0, 0.1, 0.7}),
                            primitive(SphereShape{{0.9, 0.9, 0.9}}, "chalk", {0, 0.1, 0.7})}),
                 ring("silver", {-2.7, -2.2, 0.3}), washer("plastic", {4.7, -0.3, 0}),
                 primitive(SphereShape{{0.7, 0.7, 0.7}}, "glass", {-0.9, -3.2, 0.8}),
                 primitive(BoxShape{{1.2, 0.8, 1.5}}, "glass", {3.2, -2.4, 0.9})});
  return scene;
}

Scene placed_elsewhere(Scene scene, const Placement& placement) {
  const auto point = [&](const Vector3& p) { return firmware::transform_point(placement, p); };
  scene.view.eye = point(scene.view.eye);
  scene.view.target = point(scene.view.target);
  scene.view.up = firmware::transform_direction(placement, scene.view.up);
  for (Light& light : scene.lights) {
    light.placement = placement;
  }
  scene.object.placement = firmware::concatenate(placement, scene.object.placement);
  return scene;
}

struct Picture {
  std::vector<std::uint32_t> pixels;
  firmware::RayCounts rays{};
};

template <class Real>
Picture picture_of(const PreparedScene<Real>& prepared) {
  SynthesisArea<Real> area(prepared.frame().database);
  Picture picture;
  for (std::int16_t row = 0; row < k_size.height; ++row) {
    for (std::int16_t column = 0; column < k_size.width; ++column) {
      const firmware::Pixel pixel =
          firmware::synthesize(prepared.frame(), area.view(), column, row);
      picture.pixels.push_back(pixel.rgb);
      picture.rays.reflected |= pixel.rays.reflected;
      picture.rays.refracted |= pixel.rays.refracted;
      picture.rays.shadow |= pixel.rays.shadow;
    }
  }
  return picture;
}

template <class Real>
Picture picture_of(const Scene& scene) {
  return picture_of(PreparedScene<Real>(packed_scene<Real>(scene, k_size)));
}

/// Pixels that differ by more than `allowed` in a component.
int differing(const Picture& a, const Picture& b, int allowed) {
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    int largest = 0;
    for (const unsigned shift : {0U, 8U, 16U}) {
      const auto of_a = static_cast<int>(a.pixels[i] >> shift & 0xFFU);
      const auto of_b = static_cast<int>(b.pixels[i] >> shift & 0xFFU);
      largest = std::max(largest, std::abs(of_a - of_b));
    }
    count += largest > allowed ? 1 : 0;
  }
  return count;
}

constexpr int k_pixels = k_size.width * k_size.height;

TEST_CASE("A scene scaled by a power of two gives the same bits") {
  const Picture original = picture_of<float>(lively_scene());
  CHECK(original.rays.reflected != 0);
  CHECK(original.rays.refracted != 0);
  for (const double scale : {131072.0, 1 / 131072.0, 1024.0, 0.25}) {
    CAPTURE(scale);
    CHECK(picture_of<float>(scaled(lively_scene(), scale)).pixels == original.pixels);
  }
}

TEST_CASE("A scene scaled by 1e5 or 1e-5 gives the same picture") {
  const Picture original = picture_of<float>(lively_scene());
  const Picture exact = picture_of<double>(lively_scene());
  for (const double scale : {1e5, 1e-5, 3.7}) {
    CAPTURE(scale);
    const Picture other = picture_of<float>(scaled(lively_scene(), scale));
    CHECK(differing(original, other, 1) <= k_pixels / 1000);
    CHECK(differing(original, other, 0) <= k_pixels / 50);
    CHECK(differing(exact, picture_of<double>(scaled(lively_scene(), scale)), 0) == 0);
  }
}

TEST_CASE("A scene turned and moved with its observer gives nearly the same picture") {
  firmware::trial::Random random(1301);
  const Picture original = picture_of<float>(lively_scene());
  const Picture exact = picture_of<double>(lively_scene());
  for (int trial = 0; trial < 4; ++trial) {
    Placement placement = random.rotation();
    placement[3] = random.in_cube(10);
    const Scene moved = placed_elsewhere(lively_scene(), placement);
    CHECK(differing(original, picture_of<float>(moved), 2) <= k_pixels / 200);
    CHECK(differing(exact, picture_of<double>(moved), 0) <= 2);
  }
}

TEST_CASE("Single precision shows what double precision does") {
  CHECK(differing(picture_of<float>(lively_scene()), picture_of<double>(lively_scene()), 2) <=
        k_pixels / 200);
}

TEST_CASE("A counted picture has the same pixels") {
  CHECK(picture_of<firmware::Counted>(lively_scene()).pixels ==
        picture_of<float>(lively_scene()).pixels);
}

TEST_CASE("The order of a union's children changes nothing") {
  const Picture original = picture_of<double>(lively_scene());
  Scene reversed = lively_scene();
  std::reverse(reversed.object.children.begin(), reversed.object.children.end());
  CHECK(differing(original, picture_of<double>(reversed), 0) == 0);
}

TEST_CASE("What a scene does not need is not done, and would not change its picture") {
  Scene matt = lively_scene();
  for (Surface& surface : matt.surfaces) {
    surface.specular = 0;
    surface.transparent = false;
  }
  for (const bool with_lights : {true, false}) {
    if (!with_lights) {
      matt.lights.clear();
    }
    PackedScene<float> packed = packed_scene<float>(matt, k_size);
    CHECK_FALSE(packed.header.needs.specular);
    CHECK_FALSE(packed.header.needs.reflections);
    CHECK_FALSE(packed.header.needs.transparency);
    CHECK(packed.header.needs.shadows == with_lights);
    const Picture lean = picture_of(PreparedScene<float>(packed));
    CHECK(lean.rays.reflected == 0);
    CHECK(lean.rays.refracted == 0);
    CHECK((lean.rays.shadow != 0) == with_lights);
    packed.header.needs.specular = packed.header.needs.reflections = true;
    packed.header.needs.transparency = packed.header.needs.absorption = true;
    CHECK(picture_of(PreparedScene<float>(packed)).pixels == lean.pixels);
  }
}

TEST_CASE("More depth of the tree of rays than is visible changes nothing") {
  Scene scene = lively_scene();
  scene.ray_tree.minimum_weight = 1.0 / 512;
  scene.ray_tree.depth = 12;
  const Picture deep = picture_of<float>(scene);
  scene.ray_tree.depth = 14;
  CHECK(differing(deep, picture_of<float>(scene), 1) <= k_pixels / 1000);
}

}  // namespace
}  // namespace maquette::sim
