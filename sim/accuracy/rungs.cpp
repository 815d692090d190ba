#include "sim/accuracy/rungs.hpp"

#include <algorithm>

namespace maquette::sim {

namespace {

bool has_roots(const Object& object) {
  return object.kind == ObjectKind::revolution ||
         std::any_of(object.sons.begin(), object.sons.end(), has_roots);
}

}  // namespace

std::vector<Rung> rungs_of(const Scene& scene, const std::vector<std::string>& quanta) {
  std::vector<Rung> rungs = {bus_rung(quanta), number_rung()};
  const bool has_secondary_rays = std::any_of(
      scene.surfaces.begin(), scene.surfaces.end(),
      [](const Surface& surface) { return surface.specular > 0 || surface.transparent; });
  if (has_secondary_rays) {
    rungs.push_back(depth_rung(scene.ray_tree));
    rungs.push_back(weight_rung(scene.ray_tree));
  }
  if (has_roots(scene.object)) {
    rungs.push_back(roots_rung());
  }
  return rungs;
}

std::vector<std::string> rung_names() {
  return {bus_rung({}).name, number_rung().name, depth_rung({}).name, weight_rung({}).name,
          roots_rung().name};
}

}  // namespace maquette::sim
