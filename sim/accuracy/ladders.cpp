#include "sim/accuracy/ladders.hpp"

#include <algorithm>

#include "sim/run/execution_check.hpp"

namespace maquette::sim {

namespace {

bool has_roots(const Object& object) {
  const bool is_approximate = object.primitive && object.primitive->description->root_tolerance !=
                                                      PrimitiveDescription::k_no_tolerance;
  return is_approximate || std::any_of(object.children.begin(), object.children.end(), has_roots);
}

}  // namespace

std::vector<Ladder> ladders_of(const Scene& scene, const Machine& machine,
                               const LadderChoices& choices) {
  std::vector<Ladder> ladders = {bus_ladder(choices.quanta), number_ladder()};
  if (!obstacle_to_execution(machine)) {
    ladders.insert(ladders.begin(),
                   processor_ladder(choices.share, machine.parameters.board.arithmetic.execution));
  }
  const bool has_secondary_rays = std::any_of(
      scene.surfaces.begin(), scene.surfaces.end(),
      [](const Surface& surface) { return surface.specular > 0 || surface.transparent; });
  if (has_secondary_rays) {
    ladders.push_back(depth_ladder(scene.ray_tree));
    ladders.push_back(weight_ladder(scene.ray_tree));
  }
  if (has_roots(scene.object)) {
    ladders.push_back(roots_ladder());
  }
  return ladders;
}

std::vector<std::string> ladder_names() {
  return {k_processor_ladder,    bus_ladder({}).name,    number_ladder().name,
          depth_ladder({}).name, weight_ladder({}).name, roots_ladder().name};
}

}  // namespace maquette::sim
