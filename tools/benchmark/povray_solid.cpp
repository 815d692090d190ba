#include "tools/benchmark/povray_solid.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "sim/primitives/box.hpp"
#include "sim/primitives/cone.hpp"
#include "sim/primitives/cylinder.hpp"
#include "sim/primitives/generatrix_curve.hpp"
#include "sim/primitives/half_space.hpp"
#include "sim/primitives/revolution.hpp"
#include "sim/primitives/sphere.hpp"
#include "sim/primitives/torus.hpp"

namespace maquette::benchmark {

namespace {

std::string sphere_text(const sim::SphereShape& shape) {
  const sim::Vector3& radii = shape.radii;
  return radii.x == radii.y && radii.x == radii.z
             ? fmt::format("sphere {{ 0, {:.9g}", radii.x)
             : fmt::format("sphere {{ 0, 1 scale {}", povray_vector(radii));
}

/// The ends of an axis, each followed by its radius.
std::string ends_text(const sim::Axis& axis, const std::string& low, const std::string& high) {
  return povray_vector(axis.from.value_or(sim::Vector3(0))) + low + ", " +
         povray_vector(axis.to.value_or(sim::Vector3(0, 0, axis.height.value_or(0)))) + high;
}

/// POV-Ray turns about y.
constexpr const char* k_upright = " rotate 90 * x";

std::string torus_text(const sim::TorusShape& shape) {
  return fmt::format("torus {{ {:.9g}, {:.9g}{}", shape.major_radius, shape.minor_radius,
                     k_upright);
}

/// A lathe, and the discs of an open generatrix, which a lathe does not have.
std::string revolution_text(const sim::RevolutionShape& shape, const std::string& modifiers) {
  const sim::GeneratrixCurve curve = sim::generatrix_curve(shape);
  std::string points;
  for (std::size_t section = 0; section < curve.sections(); ++section) {
    for (std::size_t i = 3 * section; i <= 3 * section + 3; ++i) {
      points += fmt::format(", <{:.9g}, {:.9g}>", curve.points[i].x, curve.points[i].y);
    }
  }
  std::string text = fmt::format("lathe {{ bezier_spline {}{}{}{} }}\n", 4 * curve.sections(),
                                 points, k_upright, modifiers);
  for (const glm::dvec2& end : {curve.points.front(), curve.points.back()}) {
    text += fmt::format("disc {{ <0, 0, {:.9g}>, z, {:.9g}{} }}\n", end.y, end.x, modifiers);
  }
  return text;
}

/// Without modifiers and the closing brace.
std::string opened_text(const sim::Primitive& primitive) {
  if (const auto* sphere = sim::shape_of<sim::SphereShape>(primitive)) {
    return sphere_text(*sphere);
  }
  if (const auto* cylinder = sim::shape_of<sim::CylinderShape>(primitive)) {
    return "cylinder { " + ends_text(cylinder->axis, "", "") +
           fmt::format(", {:.9g}", cylinder->radius);
  }
  if (const auto* cone = sim::shape_of<sim::ConeShape>(primitive)) {
    return "cone { " + ends_text(cone->axis, fmt::format(", {:.9g}", cone->radius),
                                 fmt::format(", {:.9g}", cone->top_radius));
  }
  if (const auto* torus = sim::shape_of<sim::TorusShape>(primitive)) {
    return torus_text(*torus);
  }
  if (const auto* box = sim::shape_of<sim::BoxShape>(primitive)) {
    return fmt::format("box {{ {0} / -2, {0} / 2", povray_vector(box->size));
  }
  if (sim::shape_of<sim::HalfSpaceShape>(primitive) != nullptr) {
    return "plane { z, 0";
  }
  throw std::invalid_argument("POV-Ray is not compared by this primitive");
}

}  // namespace

std::string povray_vector(const sim::Vector3& v) {
  return fmt::format("<{:.9g}, {:.9g}, {:.9g}>", v.x, v.y, v.z);
}

std::string povray_solid(const sim::Primitive& primitive, const std::string& modifiers) {
  if (const auto* revolution = sim::shape_of<sim::RevolutionShape>(primitive)) {
    return revolution_text(*revolution, modifiers);
  }
  return opened_text(primitive) + modifiers + " }\n";
}

}  // namespace maquette::benchmark
