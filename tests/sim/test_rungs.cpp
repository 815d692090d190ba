#include <algorithm>
#include <catch2/catch.hpp>
#include <set>

#include "sim/accuracy/rungs.hpp"

using namespace maquette::sim;

namespace {

bool has(const Rung& rung, const std::string& override_text) {
  return std::any_of(rung.levels.begin(), rung.levels.end(), [&](const Level& level) {
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

}  // namespace

TEST_CASE("rungs have names of their own and a reference") {
  Scene scene = scene_with({}, 1);
  scene.object.sons.resize(1);
  scene.object.sons[0].kind = ObjectKind::revolution;
  const std::vector<Rung> rungs = rungs_of(scene, default_quanta());
  std::set<std::string> names;
  for (const Rung& rung : rungs) {
    CHECK(names.insert(rung.name).second);
    CHECK(rung.reference < rung.levels.size());
    std::set<std::string> levels;
    for (const Level& level : rung.levels) {
      CHECK(levels.insert(level.name).second);
    }
  }
  const std::vector<std::string> all = rung_names();
  CHECK(names == std::set<std::string>(all.begin(), all.end()));
}

TEST_CASE("what a scene has not is not varied") {
  CHECK(rungs_of(scene_with({}, 0), {}).size() == 2);
  CHECK(rungs_of(scene_with({}, 1), {}).size() == 4);
}

TEST_CASE("the tree of rays is varied around the scene's own, where there is one") {
  CHECK(has(depth_rung({5, 0.25}), "ray_tree.depth=5"));
  CHECK(has(depth_rung({5, 0.25}), "ray_tree.minimum_weight=0.25"));
  CHECK(has(weight_rung({5, 0.03}), "ray_tree.minimum_weight=0.03"));
  CHECK(has(weight_rung({5, 0.03}), "ray_tree.depth=5"));
}

TEST_CASE("no tree of rays grows without bound") {
  for (const Rung& rung : {depth_rung({1000, 0}), weight_rung({1000, 0})}) {
    CHECK_FALSE(has(rung, "ray_tree.minimum_weight=0"));
    CHECK_FALSE(has(rung, "ray_tree.depth=1000"));
  }
}
