#include "sim/scene/scene_checks.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <string_view>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

[[noreturn]] void fail(const YamlNode& root, std::string_view key, const std::string& message) {
  throw DescriptionError(nearest_node(root, key).place.position(),
                         std::string{key} + ": " + message);
}

/// Empty where nothing speaks against a transparent surface.
std::string_view why_opaque(const Object& object) {
  return object.primitive ? object.primitive->description->why_opaque(object.primitive->shape)
                          : std::string_view{};
}

/// Looks below an object whose surface, where it names none, is that of the objects above it.
void check_opaque_below(const Object& object, const std::string& surface_above,
                        const std::vector<Surface>& surfaces) {
  const std::string& name = object.surface.empty() ? surface_above : object.surface;
  const std::string_view reason = why_opaque(object);
  if (!reason.empty()) {
    const auto surface = std::find_if(surfaces.begin(), surfaces.end(),
                                      [&](const Surface& s) { return s.name == name; });
    if (surface != surfaces.end() && surface->transparent) {
      throw DescriptionError(object.position_in_file,
                             std::string{object.primitive->description->name} + ": the surface `" +
                                 name + "` is transparent, but " + std::string{reason});
    }
  }
  for (const Object& child : object.children) {
    check_opaque_below(child, name, surfaces);
  }
}

/// Throws DescriptionError for what has no thickness below an operand that is to have an inside:
/// any but the first of a difference or an intersection, whose matter is that of the first.
void check_thick_operands(const Object& object, bool needs_inside) {
  if (needs_inside && !why_opaque(object).empty()) {
    throw DescriptionError(object.position_in_file,
                           std::string{object.primitive->description->name} +
                               ": without thickness it has no inside, by which a difference or an "
                               "intersection could cut; the first operand, which is cut, and "
                               "operands of unions are allowed to be without");
  }
  const bool is_union = object.combination == firmware::BooleanOperator::union_of;
  for (std::size_t i = 0; i < object.children.size(); ++i) {
    check_thick_operands(object.children[i], needs_inside || (i > 0 && !is_union));
  }
}

void check_texture(const Surface& surface, const YamlNode& node) {
  const Texture& texture = *surface.texture;
  if (texture.pattern.has_value() == texture.picture.has_value()) {
    throw DescriptionError(node.place.position(),
                           "texture: one of pattern, picture is allowed and needed");
  }
  if (surface.specular == 1) {
    throw DescriptionError(node.place.position(),
                           "texture: it is seen on the diffuse share, of which a surface with "
                           "specular 1 has none; less is allowed");
  }
  if (texture.picture) {
    const std::size_t needed = firmware::k_texel_bytes *
                               static_cast<std::size_t>(texture.picture->columns) *
                               static_cast<std::size_t>(texture.picture->rows);
    if (texture.picture->texels.size() != needed) {
      fail(*node.find("picture"), "texels",
           std::to_string(texture.picture->texels.size()) + " bytes, but columns and rows need " +
               std::to_string(needed));
    }
  }
}

/// Whether one of the bodies below an object has one of the surfaces.
bool has_body_of(const Object& object, const std::string& inherited,
                 const std::set<std::string_view>& surfaces) {
  const std::string& name = object.surface.empty() ? inherited : object.surface;
  return object.primitive
             ? surfaces.count(name) > 0
             : std::any_of(object.children.begin(), object.children.end(),
                           [&](const Object& child) { return has_body_of(child, name, surfaces); });
}

/// Whether a ray may go on through a body; surfaces that none has do not matter.
bool has_transparent_body(const Scene& scene) {
  std::set<std::string_view> transparent;
  for (const Surface& surface : scene.surfaces) {
    if (surface.transparent) {
      transparent.insert(surface.name);
    }
  }
  return !transparent.empty() && has_body_of(scene.object, "", transparent);
}

/// The most rays that may follow one through transparent bodies: each is followed by two, and those
/// of one depth together weigh no more than the first.
double most_rays(const RayTree& tree) {
  double rays = 0;
  double of_depth = 1;
  for (int depth = 1; depth <= tree.depth; ++depth) {
    of_depth = std::min(2 * of_depth, 1 / tree.minimum_weight);
    rays += of_depth;
  }
  return rays;
}

}  // namespace

void check_sheets(const Scene& scene) {
  check_opaque_below(scene.object, scene.object.surface, scene.surfaces);
  check_thick_operands(scene.object, false);
}

void check_light(const Light& light, const YamlNode& node) {
  if (light.spot && light.spot->target == light.position) {
    fail(*node.find("spot"), "target",
         "it is where the light is, so there is no direction to shine");
  }
}

void check_samples(const Samples& samples, const YamlNode& node) {
  constexpr int k_fewest = 3;
  if (samples.contrast > 0 && samples.per_side < k_fewest) {
    fail(
        node, "contrast",
        "a grid of less than 3 rays a side has none besides its corners; 0 or a larger per_side is "
        "allowed");
  }
}

void check_screen(const View& view, const YamlNode& node) {
  constexpr double k_largest_cosine = 1e-9;
  const Placement& place = *view.screen->placement;
  const Vector3 right = glm::normalize(place[0]);
  const Vector3 up = glm::normalize(place[1]);
  if (std::abs(glm::dot(right, up)) > k_largest_cosine) {
    fail(node, "place", "the screen's sides must stay perpendicular, since pixels are square");
  }
  const double distance = glm::dot(glm::cross(right, up), view.eye - place[3]);
  if (!(distance > k_largest_cosine * glm::length(view.eye - place[3]))) {
    fail(node, "place",
         "the eye is not in front of the screen, which is seen from the side of its z above 0");
  }
}

/// How much of the scene the picture shows is said once.
void check_window(const View& view, const YamlNode& node) {
  const int angles = (view.field_of_view_deg ? 1 : 0) + (view.horizontal_field_of_view_deg ? 1 : 0);
  const int heights = view.height ? 1 : 0;
  if (view.projection == firmware::Projection::parallel) {
    if (angles != 0 || heights + (view.screen ? 1 : 0) != 1) {
      fail(node, view.screen ? "screen" : "view",
           "of an orthographic view one of height, screen is allowed and needed, and no field of "
           "view");
    }
    return;
  }
  if (heights != 0) {
    fail(node, "height",
         "in perspective it depends on the distance; allowed where projection is orthographic");
  }
  if (angles + (view.screen ? 1 : 0) != 1) {
    fail(node, view.screen ? "screen" : "view",
         "one of field_of_view, horizontal_field_of_view, screen is allowed and needed");
  }
}

void check_view(const View& view, const YamlNode& node) {
  if (view.screen && view.screen->placement) {
    check_screen(view, *node.find("screen"));
    return;
  }
  if (view.eye == view.target) {
    fail(node, "target", "it is where the eye is, so there is no direction to look");
  }
  // The cross product of unit vectors is the sine of the angle between them.
  constexpr double k_least_sine = 1e-9;
  const Vector3 direction = glm::normalize(view.target - view.eye);
  const Vector3 up = glm::normalize(view.up);
  if (view.up == Vector3{0, 0, 0} || !(glm::length(glm::cross(direction, up)) > k_least_sine)) {
    fail(node, "up", "it has no part across the direction from eye to target; another is allowed");
  }
  check_window(view, node);
}

void check_surface(const Surface& surface, const YamlNode& node) {
  if (surface.metal && surface.transparent) {
    fail(node, "transparent", "a metal is opaque; false is allowed");
  }
  if (surface.transparent && surface.specular == 0) {
    fail(node, "specular",
         "the specular share is what goes through a transparent surface; above 0 to 1 is allowed");
  }
  if (!surface.metal && surface.index != Color{surface.index.x}) {
    fail(node, "index", "a dielectric has the same index for the three colours");
  }
  if (surface.metal &&
      (surface.index.x + surface.extinction.x == 0 || surface.index.y + surface.extinction.y == 0 ||
       surface.index.z + surface.extinction.z == 0)) {
    fail(node, "metal", "index and extinction are both 0 for one colour");
  }
  if (surface.texture) {
    check_texture(surface, *node.find("texture"));
  }
  if (!surface.transparent && surface.absorption != Color{0, 0, 0}) {
    fail(node, "absorption", "it needs `transparent: true`");
  }
}

void check_ray_tree(const Scene& scene, const YamlNode& node) {
  constexpr double k_most_rays = 1e7;
  if (has_transparent_body(scene) && !(most_rays(scene.ray_tree) <= k_most_rays)) {
    fail(node, "ray_tree",
         "with a transparent surface more than ten million rays may follow one; a larger "
         "minimum_weight or a smaller depth is allowed");
  }
}

}  // namespace maquette::sim
