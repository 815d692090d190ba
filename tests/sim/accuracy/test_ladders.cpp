#include <algorithm>
#include <set>

#include "sim/accuracy/ladders.hpp"
#include "sim/primitives/revolution.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;

namespace {

bool has(const Ladder& ladder, const std::string& override_text) {
  return std::any_of(ladder.levels.begin(), ladder.levels.end(), [&](const Level& level) {
    return std::find(level.overrides.begin(), level.overrides.end(), override_text) !=
           level.overrides.end();
  });
}

Scene scene_with(const RayTree& tree, double specular) {
  Scene scene;
  scene.ray_tree = tree;
  scene.surfaces.resize(1);
  scene.surfaces[0].specular = specular;
  return scene;
}

Machine executable_machine() {
  Machine machine;
  machine.parameters.board.arithmetic.execution = maquette::models::ArithmeticExecution::costs;
  return machine;
}

}  // namespace

TEST_CASE("ladders have names of their own and a reference") {
  Scene scene = scene_with({}, 1);
  scene.object.children.resize(1);
  scene.object.children[0].primitive = primitive_of(RevolutionShape{});
  const std::vector<Ladder> ladders = ladders_of(scene, executable_machine(), {});
  std::set<std::string> names;
  for (const Ladder& ladder : ladders) {
    CHECK(names.insert(ladder.name).second);
    CHECK(ladder.reference < ladder.levels.size());
    std::set<std::string> levels;
    for (const Level& level : ladder.levels) {
      CHECK(levels.insert(level.name).second);
    }
  }
  const std::vector<std::string> all = ladder_names();
  CHECK(names == std::set<std::string>(all.begin(), all.end()));
}

TEST_CASE("a package that is executed is held against the host's at its exact cost") {
  Machine machine = executable_machine();
  const Scene scene = scene_with({}, 0);
  CHECK_FALSE(has(ladders_of(scene, machine, {})[0], "board.arithmetic.execution=exact"));
  machine.parameters.board.arithmetic.execution = maquette::models::ArithmeticExecution::package;
  CHECK(has(ladders_of(scene, machine, {})[0], "board.arithmetic.execution=exact"));
}

TEST_CASE("what a scene has not is not varied") {
  CHECK(ladders_of(scene_with({}, 0), Machine{}, {}).size() == 2);
  CHECK(ladders_of(scene_with({}, 1), Machine{}, {}).size() == 4);
}

TEST_CASE("instructions are the reference where boards can execute them, and say what is sampled") {
  const Scene scene = scene_with({}, 0);
  const Ladder whole = ladders_of(scene, executable_machine(), {})[0];
  CHECK(whole.name == "processor");
  CHECK(whole.reference_name() == "instruction");
  LadderChoices choices;
  choices.share = 12;
  const Ladder sampled = ladders_of(scene, executable_machine(), choices)[0];
  CHECK(sampled.reference_name() == "instruction 1/12");
  CHECK(sampled.varies.find("extrapolated") != std::string::npos);
  CHECK(sampled.levels[sampled.reference].share == 12);
  for (const Ladder& ladder : ladders_of(scene, Machine{}, {})) {
    CHECK(ladder.name != "processor");
  }
}

TEST_CASE("the tree of rays is varied around the scene's own, where there is one") {
  CHECK(has(depth_ladder({5, 0.25}), "ray_tree.depth=5"));
  CHECK(has(depth_ladder({5, 0.25}), "ray_tree.minimum_weight=0.25"));
  CHECK(has(weight_ladder({5, 0.03}), "ray_tree.minimum_weight=0.03"));
  CHECK(has(weight_ladder({5, 0.03}), "ray_tree.depth=5"));
}

TEST_CASE("no tree of rays grows without bound") {
  for (const Ladder& ladder : {depth_ladder({1000, 0}), weight_ladder({1000, 0})}) {
    CHECK_FALSE(has(ladder, "ray_tree.minimum_weight=0"));
    CHECK_FALSE(has(ladder, "ray_tree.depth=1000"));
  }
}
