#include "sim/stability/crease_scenes.hpp"

#include <cmath>
#include <glm/trigonometric.hpp>
#include <iterator>
#include <utility>

#include "sim/primitives/box.hpp"
#include "sim/primitives/cone.hpp"
#include "sim/primitives/cylinder.hpp"
#include "sim/primitives/half_space.hpp"
#include "sim/primitives/sphere.hpp"
#include "sim/scene/placement.hpp"
#include "sim/stability/random_tree.hpp"
#include "sim/stability/trial_scene.hpp"

namespace maquette::sim {

namespace {

using firmware::BooleanOperator;
using trial::Random;

/// Unions twice, since of intersections there is less to see.
constexpr BooleanOperator k_operators[] = {BooleanOperator::union_of, BooleanOperator::union_of,
                                           BooleanOperator::intersection,
                                           BooleanOperator::difference};

const char* random_surface(Random& random) {
  constexpr int k_opaque = 2;
  return k_trial_surfaces[random.below(k_opaque)];
}

Object with_surface(Random& random, Object object) {
  object.surface = random_surface(random);
  return object;
}

Object solid_of(Random& random, Primitive primitive, const Placement& placement) {
  Object object;
  object.primitive = std::move(primitive);
  object.placement = placement;
  return with_surface(random, std::move(object));
}

/// The object around the origin, of a size of about 1, in a frame of any size and turn, seen from
/// around a direction and lit from the observer's side.
Scene seen(Random& random, Object object, const Vector3& from) {
  const double size = random.magnitude(1e-2, 1e2);
  const Vector3 middle = random.in_cube(3) * size;
  Scene scene = scene_of(Object{});
  scene.surfaces[0].diffuse = {0.9, 0.3, 0.2};
  scene.surfaces[1].diffuse = {0.2, 0.5, 0.9};
  const Placement turn = random.rotation();
  const Placement frame =
      concatenated(trial::moved(middle), concatenated(turn, trial::scaled({size, size, size})));
  const Vector3 towards = firmware::transform_direction(turn, from);
  object.placement = concatenated(frame, object.placement);
  scene.object = std::move(object);
  // From afar the crossings of a ray are less apart for their rounding.
  const double distance = random.magnitude(3, 30);
  scene.view.eye = middle + towards * (size * distance);
  scene.view.target = middle + random.in_cube(0.5) * size;
  scene.view.up = random.direction();
  scene.view.field_of_view_deg = glm::degrees(2 * std::atan(0.6 / distance));
  scene.ambient = {0.1, 0.1, 0.1};
  const int lights = 1 + random.below(2);
  for (int light = 0; light < lights; ++light) {
    const Vector3 aside = random.direction_around(towards, random.uniform(0, 1));
    Light& lamp = scene.lights.emplace_back();
    lamp.position = middle + aside * (size * random.uniform(4, 20));
    lamp.intensity = {2, 2, 2};
  }
  return scene;
}

/// Solids of every family over and in one another.
Scene overlapping(Random& random, const std::vector<SolidFamily>& families) {
  constexpr int k_most_solids = 6;
  std::vector<Object> objects;
  const int count = 2 + random.below(k_most_solids - 1);
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<std::size_t>(random.below(static_cast<int>(families.size())));
    const Placement placement = random.placement(random.in_cube(0.8), random.uniform(0.4, 1.2), 3);
    objects.push_back(with_surface(random, random_solid(random, families[family], placement)));
  }
  while (objects.size() > 1) {
    const auto a = objects.begin() + random.below(static_cast<int>(objects.size()) - 1);
    *a = combined(k_operators[random.below(std::size(k_operators))],
                  {std::move(a[0]), std::move(a[1])});
    objects.erase(a + 1);
  }
  return seen(random, std::move(objects.front()), random.direction());
}

/// Solids of every family half sunk in a floor.
Scene sunk(Random& random, const std::vector<SolidFamily>& families) {
  constexpr int k_most_solids = 9;
  std::vector<Object> objects;
  objects.push_back(
      random.coin()
          ? solid_of(random, primitive_of(HalfSpaceShape{}), trial::unmoved())
          : solid_of(random, primitive_of(BoxShape{{6, 6, 2}}), trial::moved({0, 0, -1})));
  const int count = 1 + random.below(k_most_solids);
  for (int i = 0; i < count; ++i) {
    const auto family = static_cast<std::size_t>(random.below(static_cast<int>(families.size())));
    const Vector3 place(random.uniform(-1.5, 1.5), random.uniform(-1.5, 1.5), 0);
    objects.push_back(
        with_surface(random, random_solid(random, families[family],
                                          random.placement(place, random.uniform(0.2, 0.6), 2))));
  }
  const Vector3 above = random.direction_around({0, 0, 1}, random.uniform(0.1, 1));
  return seen(random, combined(BooleanOperator::union_of, std::move(objects)), above);
}

/// A box, cylinder or cone whose flat faces lie in planes of a coarse grid. Round sides are
/// circular and narrower than the grid, so that they coincide or do not touch: near a line where
/// they touch, bodies may be apart by less than rounding over more than a pixel.
Object on_grid(Random& random) {
  constexpr double k_grid = 0.25;
  constexpr double k_narrower = 0.9;
  const auto half = [&random] { return k_grid * (1 + random.below(3)); };
  const auto at = [&random] { return k_grid * (random.below(5) - 2); };
  const double radius = k_narrower * half();
  const double across = half();
  const double width = half();
  const double height = half();
  const double x = at();
  const double y = at();
  const Placement middle = trial::moved({x, y, at()});
  const Placement round = concatenated(middle, trial::scaled({radius, radius, height}));
  switch (random.below(4)) {
    case 0:
      return solid_of(random, primitive_of(CylinderShape{1, {2}}), round);
    case 1:
      return solid_of(random, primitive_of(ConeShape{1, 0, {2}}), round);
    default:
      return solid_of(random, primitive_of(BoxShape{{2, 2, 2}}),
                      concatenated(middle, trial::scaled({across, width, height})));
  }
}

/// Solids with common planes, edges and axes.
Scene coincident(Random& random, const std::vector<SolidFamily>& /*families*/) {
  constexpr int k_most_solids = 6;
  Object object = on_grid(random);
  const int count = 1 + random.below(k_most_solids - 1);
  for (int i = 0; i < count; ++i) {
    object = combined(k_operators[random.below(std::size(k_operators))],
                      {std::move(object), on_grid(random)});
  }
  return seen(random, std::move(object), random.direction());
}

}  // namespace

const std::vector<CreaseScenes>& crease_scenes() {
  static const std::vector<CreaseScenes> kinds{{"solids that overlap", overlapping},
                                               {"solids half sunk in a floor", sunk},
                                               {"solids with coincident faces", coincident}};
  return kinds;
}

}  // namespace maquette::sim
