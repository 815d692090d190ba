#include "firmware/work_area.hpp"

#include "tests/catch.hpp"
#include "tests/firmware/random_model.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Random;

TEST_CASE("Crossings of operands and of their combination lie one behind the other") {
  const CrossingNeeds leaf{2, 2};
  const CrossingNeeds pair = combined_crossing_needs(leaf, leaf);
  CHECK(pair.result == 4);
  CHECK(pair.space == 8);
  // First operand, then all that the second takes, or twice the result.
  const CrossingNeeds chain = combined_crossing_needs(leaf, pair);
  CHECK(chain.result == 6);
  CHECK(chain.space == 12);
  const CrossingNeeds deep = combined_crossing_needs({2, 2}, {4, 40});
  CHECK(deep.space == 42);
}

TEST_CASE("Rays wait as many as the depth of their tree") {
  CHECK(pending_rays_needed(0, true) == 1);
  CHECK(pending_rays_needed(4, true) == 5);
  CHECK(pending_rays_needed(4, false) == 1);
}

TEST_CASE("No ray needs more room than the work areas have") {
  Random random(801);
  std::size_t most_crossings = 0;
  for (int trial = 0; trial < 150; ++trial) {
    Model model;
    model.surfaces = {trial::glass_surface(1.5), trial::mirror_surface(), trial::matt_surface(),
                      trial::glass_surface(1.2)};
    model.lights = {{{50, 80, 0}, {1, 1, 1}}};
    model.ray_depth = random.below(6);
    model.minimum_weight = 0;
    model.columns = model.rows = 12;
    const auto tree = trial::random_tree(random, model, 4 + random.below(10), {0, 0, 12}, 10);
    BuiltFrame<float> built(tree.model, tree.root);
    for (std::int16_t row = 0; row < model.rows; ++row) {
      for (std::int16_t column = 0; column < model.columns; ++column) {
        built.pixel(column, row);
        const auto query = primary_ray(built.frame.database, column, row);
        const std::size_t count = built.crossings_of(query).size();
        most_crossings = larger(most_crossings, count);
        REQUIRE(static_cast<std::int64_t>(count) <= built.needs().result);
      }
    }
    REQUIRE(built.guards_are_whole());
  }
  CHECK(most_crossings >= 6);
}

TEST_CASE("A chain that uses all of the space keeps within it") {
  // Bars one behind the other, each of its own combination on the second side.
  Model model;
  NodeIndex root = model.add(kind_of<sphere::Kind>, trial::moved({0, 0, 40}));
  for (int i = 9; i > 0; --i) {
    const NodeIndex bar = model.add(kind_of<sphere::Kind>, trial::moved({0, 0, 4.0 * i}));
    root = model.combine(BooleanOperator::union_of, bar, root);
  }
  BuiltFrame<float> built(model, root);
  const auto crossings = built.crossings_of({0, 0, 0}, {0, 0, 1});
  CHECK(static_cast<std::int64_t>(crossings.size()) == built.needs().result);
  CHECK(built.guards_are_whole());
}

}  // namespace
}  // namespace maquette::firmware
