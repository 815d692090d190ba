#include "sim/database/object_tree.hpp"

#include <algorithm>

#include "sim/primitives/sphere.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/database/sample_objects.hpp"

namespace maquette::sim {
namespace {

using firmware::BooleanOperator;
using firmware::NodeIndex;
using firmware::trial::Random;

Object ball_at(const Vector3& place) {
  Object ball;
  ball.primitive = primitive_of(SphereShape{});
  ball.placement[3] = place;
  return ball;
}

/// A union of balls; `carved` of them less a ball each.
Scene scattered(Random& random, int balls, int carved) {
  std::vector<Object> children;
  for (int i = 0; i < balls; ++i) {
    Object ball = ball_at(random.in_cube(9));
    if (i < carved) {
      ball = combined(BooleanOperator::difference, {ball, ball_at(random.in_cube(9))});
    }
    children.push_back(ball);
  }
  Scene scene;
  scene.surfaces.emplace_back().name = "matt";
  scene.object = combined(BooleanOperator::union_of, std::move(children));
  return scene;
}

struct LeafRange {
  NodeIndex first;
  NodeIndex end;
};

}  // namespace

TEST_CASE("The leaves below a node of the tree are numbered in a row") {
  Random random(2201);
  for (int i = 0; i < 40; ++i) {
    const ObjectTree tree =
        object_tree_of(scattered(random, 2 + random.below(60), random.below(5)));
    std::vector<LeafRange> ranges;
    for (NodeIndex leaf = 0; leaf < tree.leaves.size(); ++leaf) {
      ranges.push_back({leaf, leaf + 1});
    }
    for (const firmware::Composite& composite : tree.composites) {
      const LeafRange& a = ranges[composite.children[0]];
      const LeafRange& b = ranges[composite.children[1]];
      REQUIRE(a.end == b.first);
      ranges.push_back({a.first, b.end});
    }
    REQUIRE(ranges[tree.root].end == tree.leaves.size());
  }
}

TEST_CASE("Every leaf of a tree keeps its own place and parent") {
  Random random(2202);
  const Scene scene = scattered(random, 50, 0);
  const ObjectTree tree = object_tree_of(scene);
  for (const Object& ball : scene.object.children) {
    CHECK(std::count_if(tree.leaves.begin(), tree.leaves.end(), [&](const TreeLeaf& leaf) {
            return leaf.to_scene[3] == ball.placement[3];
          }) == 1);
  }
  for (NodeIndex leaf = 0; leaf < tree.leaves.size(); ++leaf) {
    const auto parent = tree.leaves[leaf].parent - tree.leaves.size();
    const auto& children = tree.composites[parent].children;
    CHECK((children[0] == leaf || children[1] == leaf));
  }
}

}  // namespace maquette::sim
