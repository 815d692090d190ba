#include <algorithm>
#include <cmath>

#include "firmware/arithmetic/counted.hpp"
#include "models/board/work_cost.hpp"
#include "sim/database/frame_synthesis.hpp"
#include "sim/database/large_union.hpp"
#include "sim/machine/machine_description.hpp"
#include "sim/primitives/box.hpp"
#include "sim/primitives/half_space.hpp"
#include "sim/primitives/sphere.hpp"
#include "sim/scene/description_loader.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/database/sample_objects.hpp"

namespace maquette::sim {
namespace {

using firmware::BooleanOperator;
using firmware::trial::Random;

Object at(Primitive primitive, const Vector3& place) {
  Object object;
  object.primitive = std::move(primitive);
  object.placement[3] = place;
  return object;
}

/// Spheres and boxes in a cube of two units, the first of as many as may be asked for.
std::vector<Object> bodies(int number, double radius) {
  Random random(2801);
  std::vector<Object> result;
  for (int i = 0; i < number; ++i) {
    Primitive primitive = i % 2 == 0 ? primitive_of(SphereShape{Vector3(radius)})
                                     : primitive_of(BoxShape{Vector3(1.6 * radius)});
    result.push_back(at(std::move(primitive), random.in_cube(1)));
  }
  return result;
}

Scene scene_of(std::vector<Object> children) {
  Scene scene;
  scene.view.eye = {0.3, -4, 1.1};
  scene.view.target = {0, 0, 0};
  scene.view.field_of_view_deg = 40;
  scene.lights.push_back({"sun", {3, -5, 8}, {1, 1, 1}, {}, {}, {}});
  scene.surfaces.emplace_back().name = "matt";
  scene.object = combined(BooleanOperator::union_of, std::move(children));
  return scene;
}

bool has_boxes(std::vector<Object> children) {
  return takes_boxes(object_tree_of(scene_of(std::move(children))));
}

/// The fewest of such bodies whose boxes are taken.
int fewest_in_boxes(double radius) {
  int without = 1;
  int with = 2 * static_cast<int>(k_always_in_boxes);
  while (with - without > 1) {
    const int middle = (with + without) / 2;
    (has_boxes(bodies(middle, radius)) ? with : without) = middle;
  }
  return with;
}

/// What a board's clock counts for the picture of so many bodies.
double board_clocks(int number, double radius) {
  DescriptionSources sources;
  sources.data_directory = MAQUETTE_PROJECT_DIRECTORY;
  std::vector<InputFile> files;
  const models::WorkCost cost(load_machine(sources, files).parameters.board);
  const PreparedScene<firmware::Counted> scene(
      packed_scene<firmware::Counted>(scene_of(bodies(number, radius)), {128, 96}));
  firmware::reset_counted_work();
  static_cast<void>(synthesized_frame(scene));
  const firmware::LongWork work = firmware::long_counted_work();
  double milliclocks = 0;
  for (int i = 0; i < firmware::k_operation_count; ++i) {
    milliclocks += static_cast<double>(cost.milliclocks(static_cast<firmware::Operation>(i))) *
                   static_cast<double>(work.counts[i]);
  }
  return milliclocks / 1e3;
}

}  // namespace

TEST_CASE("A further body never makes a picture much faster, on a board, by the boxes it brings") {
  for (const double radius : {0.19, 0.12, 0.08, 0.06, 0.01}) {
    const int fewest = fewest_in_boxes(radius);
    const double without = board_clocks(fewest - 1, radius);
    const double with = board_clocks(fewest, radius);
    INFO(fewest << " bodies of radius " << radius << ": " << with / without);
    CHECK(with > 0.95 * without);
    CHECK(with < 2 * without);
  }
}

TEST_CASE("Boxes are taken of many bodies behind one another, and of very many") {
  const int fewest = static_cast<int>(k_fewest_in_boxes);
  CHECK_FALSE(has_boxes(bodies(fewest - 1, 0.5)));
  CHECK(has_boxes(bodies(fewest, 0.5)));
  CHECK_FALSE(has_boxes(bodies(fewest, 0.05)));
  const int always = static_cast<int>(k_always_in_boxes);
  CHECK_FALSE(has_boxes(bodies(always - 1, 0.001)));
  CHECK(has_boxes(bodies(always, 0.001)));
}

TEST_CASE("A carved body is one, and bodies without bounds are none") {
  const int fewest = static_cast<int>(k_fewest_in_boxes);
  std::vector<Object> carved;
  for (const Object& body : bodies(fewest - 1, 0.5)) {
    carved.push_back(combined(BooleanOperator::difference, {body, body}));
  }
  CHECK_FALSE(has_boxes(carved));
  carved.push_back(at(primitive_of(HalfSpaceShape{}), {0, 0, 0}));
  CHECK_FALSE(has_boxes(carved));
  carved.push_back(carved.front());
  CHECK(has_boxes(carved));
}

}  // namespace maquette::sim
