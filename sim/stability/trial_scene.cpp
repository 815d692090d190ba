#include "sim/stability/trial_scene.hpp"

#include <utility>

#include "sim/scene/placement.hpp"

namespace maquette::sim {

Scene scene_of(Object object) {
  Scene scene;
  for (const char* name : k_trial_surfaces) {
    scene.surfaces.emplace_back().name = name;
  }
  scene.surfaces.back().specular = 1;
  scene.surfaces.back().transparent = true;
  scene.view.eye = {0, 0, 0};
  scene.view.target = {0, 0, -1};
  scene.view.up = {0, 1, 0};
  scene.view.field_of_view_deg = 60;
  // The screen frame looks along z, a scene with this view against it.
  const Placement mirrored{1, 0, 0, 0, 1, 0, 0, 0, -1, 0, 0, 0};
  object.placement = concatenated(mirrored, object.placement);
  scene.object = std::move(object);
  return scene;
}

}  // namespace maquette::sim
