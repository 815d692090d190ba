#include "tools/benchmark/povray_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "sim/scene/placement.hpp"
#include "tools/benchmark/povray_solid.hpp"

namespace maquette::benchmark {

namespace {

constexpr double k_pi = 3.14159265358979323846;

std::string placement_text(const sim::Placement& placement) {
  const bool is_turned = placement[0] != sim::Vector3(1, 0, 0) ||
                         placement[1] != sim::Vector3(0, 1, 0) ||
                         placement[2] != sim::Vector3(0, 0, 1);
  if (!is_turned) {
    return placement[3] == sim::Vector3(0) ? "" : " translate " + povray_vector(placement[3]);
  }
  std::string numbers;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row) {
      numbers += fmt::format("{}{:.9g}", numbers.empty() ? "" : ", ", placement[column][row]);
    }
  }
  return " matrix <" + numbers + ">";
}

/// The textures of all surfaces, and of transparent ones the interior.
std::string surface_text(const sim::Surface& surface, double ambient) {
  const std::string& name = surface.name;
  if (surface.transparent) {
    return fmt::format(
        "#declare T_{0} = texture {{ pigment {{ rgbt 1 }} finish {{ ambient 0 diffuse 0 specular "
        "0.3 roughness 0.01 reflection {{ 0, 1 fresnel }} conserve_energy }} }}\n"
        "#declare I_{0} = interior {{ ior {1:.9g} }}\n",
        name, surface.index.x);
  }
  const std::string mirror =
      surface.specular > 0
          ? fmt::format(" specular 0.3 roughness 0.01 reflection {:.9g}", surface.specular)
          : "";
  return fmt::format(
      "#declare T_{} = texture {{ pigment {{ rgb {} }} finish {{ ambient {:.9g} diffuse {:.9g}{} "
      "}} }}\n",
      name, povray_vector(surface.diffuse), ambient, 1 - surface.specular, mirror);
}

std::string modifiers_of(const sim::Scene& scene, const std::string& surface,
                         const sim::Placement& placement) {
  const auto found = std::find_if(scene.surfaces.begin(), scene.surfaces.end(),
                                  [&](const sim::Surface& each) { return each.name == surface; });
  return placement_text(placement) + fmt::format(" texture {{ T_{} }}", surface) +
         (found->transparent ? fmt::format(" interior {{ I_{} }}", surface) : "");
}

const char* operator_text(firmware::BooleanOperator combination) {
  switch (combination) {
    case firmware::BooleanOperator::union_of:
      return "union";
    case firmware::BooleanOperator::intersection:
      return "intersection";
    case firmware::BooleanOperator::difference:
      break;
  }
  return "difference";
}

std::string object_text(const sim::Scene& scene, const sim::Object& object,
                        const std::string& inherited) {
  const std::string& surface = object.surface.empty() ? inherited : object.surface;
  if (object.primitive) {
    return povray_solid(*object.primitive, modifiers_of(scene, surface, object.placement));
  }
  std::string children;
  for (const sim::Object& child : object.children) {
    children += object_text(scene, child, surface);
  }
  return fmt::format(
      "{} {{\n{}{} }}\n", operator_text(object.combination), children,
      placement_text(object.placement) +
          (object.surface.empty() ? "" : modifiers_of(scene, surface, sim::Placement(1.0))));
}

std::string camera_text(const sim::View& view, int width, int height) {
  const double screen_height = 2 * std::tan(glm::radians(*view.field_of_view_deg) / 2);
  // POV-Ray's frame is left-handed.
  return fmt::format(
      "camera {{ location {} direction z right -{:.9g} * x up {:.9g} * y sky z "
      "look_at {} }}\n",
      povray_vector(view.eye), screen_height * width / height, screen_height,
      povray_vector(view.target));
}

}  // namespace

std::string povray_text(const sim::Scene& scene, int width, int height) {
  std::string text = fmt::format(
      "#version 3.7;\nglobal_settings {{ assumed_gamma 1 max_trace_level {} }}\n"
      "background {{ rgb {} }}\n",
      scene.ray_tree.depth + 1, povray_vector(scene.background));
  text += camera_text(scene.view, width, height);
  for (const sim::Light& light : scene.lights) {
    text += fmt::format("light_source {{ {}, rgb {} }}\n", povray_vector(light.position),
                        povray_vector(light.intensity / k_pi));
  }
  for (const sim::Surface& surface : scene.surfaces) {
    text += surface_text(surface, scene.ambient.x);
  }
  // On their own POV-Ray bounds the bodies of a scene best.
  for (const sim::Object& body : scene.object.children) {
    text += object_text(scene, body, scene.object.surface);
  }
  return text;
}

}  // namespace maquette::benchmark
