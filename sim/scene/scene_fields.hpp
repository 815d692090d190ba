#pragma once

#include <optional>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/scene/placement.hpp"
#include "sim/scene/scene.hpp"
#include "sim/scene/sequence.hpp"

/// Every parameter of a scene besides its object tree, declared once.
namespace maquette::sim {

/// The most texels along one side of a picture: more do not fit into any board.
inline constexpr int k_most_texels_a_side = 4096;

inline constexpr TripleType k_point{{-k_largest_length, k_largest_length}};
inline constexpr TripleType k_intensity{{0, 1e6}, true};
inline constexpr TripleType k_reflectance{{0, 1}, true};
inline constexpr TripleType k_optical_constant{{0, 100}, true};

/// A group that is there or not, as an optional value.
template <class Visitor, class Value, class Body>
void declare_optional(Visitor& visitor, const Declaration& declaration, std::optional<Value>& value,
                      Body body) {
  bool is_there = value.has_value();
  Value kept = value.value_or(Value{});
  visitor.optional_group(declaration, is_there, [&] { body(kept); });
  if (is_there) {
    value = std::move(kept);
  }
}

template <class Visitor>
void declare_screen(Visitor& visitor, Screen& screen) {
  visitor.field({"place",
                 "of a rectangle around the origin of x and y, seen from z above 0, as of an "
                 "object; without it, it is in front of the eye"},
                screen.placement, PlacementType{});
  if (!screen.placement) {
    visitor.field(required("distance", "from the eye, in scene units"), screen.distance, k_length);
  }
  visitor.field(required("width", "in scene units"), screen.width, k_length);
  visitor.field(required("height", "in scene units"), screen.height, k_length);
}

inline ChoiceType<firmware::Projection> projection_choices() {
  return {{{"perspective", firmware::Projection::perspective},
           {"orthographic", firmware::Projection::parallel}}};
}

template <class Visitor>
void declare_view(Visitor& visitor, View& view) {
  visitor.field(required("eye", "where the observer stands"), view.eye, k_point);
  visitor.field({"projection", "onto the screen, perspective if not said"}, view.projection,
                projection_choices());
  declare_optional(visitor, {"screen", "rectangle in front of the eye; or give a field_of_view"},
                   view.screen, [&](Screen& screen) { declare_screen(visitor, screen); });
  if (view.screen && view.screen->placement) {
    return;  // it says where the eye looks
  }
  visitor.field(required("target", "a point in the middle of the picture"), view.target, k_point);
  visitor.field({"up", "direction that is up in the picture"}, view.up, k_point);
  visitor.field({"field_of_view", "vertical angle; or give a screen"}, view.field_of_view_deg,
                RealType{RealDimension::angle, {0.001, 179}});
  visitor.field({"horizontal_field_of_view", "the angle across; or give a screen"},
                view.horizontal_field_of_view_deg, RealType{RealDimension::angle, {0.001, 179}});
  visitor.field({"height", "of what an orthographic view shows, in scene units; or give a screen"},
                view.height, k_length);
}

template <class Visitor>
void declare_spot(Visitor& visitor, Spot& spot) {
  visitor.field(required("target", "a point that it is turned to"), spot.target, k_point);
  visitor.field({"angle", "from its axis, within which it shines whole"}, spot.angle_deg,
                RealType{RealDimension::angle, {0, 170}});
  visitor.field({"edge", "over which it falls to nothing beyond that"}, spot.edge_deg,
                RealType{RealDimension::angle, {0.01, 10}});
}

template <class Visitor>
void declare_light(Visitor& visitor, Light& light) {
  visitor.field({"place", "of its position and target, as of an object"}, light.placement,
                PlacementType{});
  visitor.field(required("position", "of the point source"), light.position, k_point);
  visitor.field({"intensity", "what a facing surface receives: red, green, blue"}, light.intensity,
                k_intensity);
  visitor.field({"falloff",
                 "distance at which it has its intensity, which falls off with the "
                 "square of the distance; without it, it is the same everywhere"},
                light.falloff, k_length);
  declare_optional(visitor, {"spot", "shines in a cone only"}, light.spot,
                   [&](Spot& spot) { declare_spot(visitor, spot); });
}

/// The rows of the firmware's table of distributions.
inline ChoiceType<firmware::FacetKind> facet_choices() {
  ChoiceType<firmware::FacetKind> type;
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    const auto facets = static_cast<firmware::FacetKind>(kind);
    type.choices.emplace_back(firmware::distribution_of(facets).name, facets);
  }
  return type;
}

template <class Visitor>
void declare_facets(Visitor& visitor, Surface& surface) {
  visitor.field({"facets", "distribution of the facets' slopes (Blinn)"}, surface.facets,
                facet_choices());
  visitor.field({"half_angle", "where the distribution falls to one half"}, surface.half_angle_deg,
                RealType{RealDimension::angle, {0.01, 89}});
}

/// The patterns among the rows of the firmware's table of textures.
inline ChoiceType<firmware::TextureKind> pattern_choices() {
  ChoiceType<firmware::TextureKind> type;
  for (int kind = 0; kind < firmware::k_texture_kind_count; ++kind) {
    const firmware::TextureDescription& row = firmware::k_textures.rows[kind];
    if (!row.is_mapped) {
      type.choices.emplace_back(row.name, static_cast<firmware::TextureKind>(kind));
    }
  }
  return type;
}

template <class Visitor>
void declare_picture(Visitor& visitor, TexturePicture& picture) {
  const WholeType side{WholeDimension::count, {1, k_most_texels_a_side}};
  visitor.field(required("columns", "of texels"), picture.columns, side);
  visitor.field(required("rows", "of texels"), picture.rows, side);
  visitor.field(required("texels", "from the top left: red, green, blue as hexadecimal bytes"),
                picture.texels, HexadecimalType{});
}

/// A pattern or a picture.
template <class Visitor>
void declare_texture(Visitor& visitor, Texture& texture) {
  const ChoiceType<TextureFrame> frames{
      {{"object", TextureFrame::object}, {"primitive", TextureFrame::primitive}}};
  visitor.field({"pattern", "of two colours in turn; or give a picture"}, texture.pattern,
                pattern_choices());
  declare_optional(
      visitor, {"picture", "a PNG file of 24 bits, or its texels; tinted by `diffuse`"},
      texture.picture, [&](TexturePicture& picture) { declare_picture(visitor, picture); });
  if (!texture.picture) {
    visitor.field({"color", "the second, besides `diffuse`: red, green, blue"}, texture.color,
                  k_reflectance);
    visitor.field({"size", "of a cell of the pattern"}, texture.size, k_length);
    visitor.field({"frame",
                   "that the pattern lies in: of the object with the surface, or of each "
                   "primitive"},
                  texture.frame, frames);
    visitor.field({"place", "of the pattern in its frame, as of an object"}, texture.placement,
                  PlacementType{});
  }
  if (!texture.pattern) {
    const WholeType repeats{WholeDimension::count, {1, 1000}};
    visitor.field({"repeat_u", "times the picture goes along the surface's first parameter"},
                  texture.repeat_u, repeats);
    visitor.field({"repeat_v", "and along the second"}, texture.repeat_v, repeats);
  }
}

/// A dielectric gives `index`, a metal `metal: {index, extinction}`.
template <class Visitor>
void declare_surface(Visitor& visitor, Surface& surface) {
  visitor.field({"transparent", "light goes through the body"}, surface.transparent, FlagType{});
  if (surface.transparent && surface.specular == 0) {
    surface.specular = 1;  // the default: what is not reflected goes through
  }
  visitor.field({"diffuse", "reflectance of the diffuse share: red, green, blue"}, surface.diffuse,
                k_reflectance);
  visitor.field(
      {"specular", "share of specular reflection, 1 where transparent; the rest is diffuse"},
      surface.specular, RealType{RealDimension::fraction, {0, 1}});
  visitor.optional_group({"metal", "index and extinction give its reflectance"}, surface.metal,
                         [&] {
                           visitor.field(required("index", "of refraction: red, green, blue"),
                                         surface.index, k_optical_constant);
                           visitor.field(required("extinction", "coefficient: red, green, blue"),
                                         surface.extinction, k_optical_constant);
                         });
  if (!surface.metal) {
    visitor.field({"index", "of refraction, against the surroundings"}, surface.index,
                  TripleType{{0.01, 100}, true});
  }
  declare_facets(visitor, surface);
  visitor.field({"absorption", "of the body per scene unit: red, green, blue"}, surface.absorption,
                TripleType{{0, 1e9}, true});
  visitor.field({"ambient", "uniform light besides that of the scene: red, green, blue"},
                surface.ambient, k_intensity);
  declare_optional(visitor, {"texture", "a pattern or a picture on the diffuse share"},
                   surface.texture, [&](Texture& texture) { declare_texture(visitor, texture); });
}

template <class Visitor>
void declare_samples(Visitor& visitor, Samples& samples) {
  visitor.field(required("per_side", "of a regular grid of rays over each pixel"), samples.per_side,
                WholeType{WholeDimension::count, {1, 16}});
  visitor.field({"contrast",
                 "between rays in the grid's corners, from which on the others are cast; "
                 "0: always"},
                samples.contrast, RealType{RealDimension::fraction, {0, 1}});
}

template <class Visitor>
void declare_ray_tree(Visitor& visitor, RayTree& tree) {
  visitor.field({"depth", "secondary rays in a row; 0: primary rays only"}, tree.depth,
                WholeType{WholeDimension::count, {0, 1000}});
  visitor.field({"minimum_weight", "rays that count less are not cast"}, tree.minimum_weight,
                RealType{RealDimension::fraction, {0, 1}});
}

template <class Visitor>
void declare_roots(Visitor& visitor, Roots& roots) {
  visitor.field(
      {"tolerance", "of the roots that give a ray's hits with revolutions and tori, in ulps"},
      roots.tolerance, RealType{RealDimension::number, {1, 1e6}});
}

template <class Visitor>
void declare_paper_time(Visitor& visitor, Scene& scene) {
  constexpr WholeType k_longest_time{WholeDimension::time, {1, models::k_longest_run.count()}};
  bool has_time = scene.paper_time.has_value();
  PaperTime time = scene.paper_time.value_or(PaperTime{});
  visitor.optional_group(
      {"paper_time", "that the paper states for this picture, shown beside the simulated one"},
      has_time, [&] {
        visitor.field(required("value", "of the frame"), time.value, k_longest_time);
        visitor.field(required("source", "where the paper states it"), time.source, TextType{});
      });
  if (has_time) {
    scene.paper_time = time;
  }
}

inline ChoiceType<Extents> extents_choices() {
  return {{{"all", Extents::all},
           {"none", Extents::none},
           {"rectangles", Extents::rectangles},
           {"boxes", Extents::boxes},
           {"spheres", Extents::spheres}}};
}

/// Lights, surfaces and the object tree come besides: they are named or nested.
template <class Visitor>
void declare_scene(Visitor& visitor, Scene& scene) {
  visitor.field({"name", "of the scene"}, scene.name, FileNameType{});
  declare_paper_time(visitor, scene);
  visitor.field({"extents", "that rays are compared with, all if not said; for counted work alone"},
                scene.extents, extents_choices());
  visitor.group(required("view", "the observer"), [&] { declare_view(visitor, scene.view); });
  visitor.field({"ambient", "uniform light from everywhere: red, green, blue"}, scene.ambient,
                k_intensity);
  visitor.field({"background", "where no object is: red, green, blue"}, scene.background,
                k_intensity);
  visitor.field(
      {"sequence", "frames that follow one another, in which parameters have other values"},
      scene.sequence, SequenceType{});
  declare_optional(visitor, {"samples", "rays of each pixel; without it one"}, scene.samples,
                   [&](Samples& samples) { declare_samples(visitor, samples); });
  visitor.field({"shadows", "lights are blocked by objects"}, scene.shadows, FlagType{});
  visitor.group({"ray_tree", "where the binary tree of rays ends"},
                [&] { declare_ray_tree(visitor, scene.ray_tree); });
  visitor.group({"roots", "how near numerical solutions come to the exact ones"},
                [&] { declare_roots(visitor, scene.roots); });
}

}  // namespace maquette::sim
