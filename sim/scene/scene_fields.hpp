#pragma once

#include <optional>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/scene/scene.hpp"

/// Every parameter of a scene besides its object tree, declared once.
namespace maquette::sim {

inline constexpr TripleType k_point{{-k_largest_length, k_largest_length}};
inline constexpr TripleType k_intensity{{0, 1e6}, true};
inline constexpr TripleType k_reflectance{{0, 1}, true};
inline constexpr TripleType k_optical_constant{{0, 100}, true};

template <class Visitor>
void declare_screen(Visitor& visitor, Screen& screen) {
  visitor.field(required("distance", "from the eye, in scene units"), screen.distance, k_length);
  visitor.field(required("width", "in scene units"), screen.width, k_length);
  visitor.field(required("height", "in scene units"), screen.height, k_length);
}

template <class Visitor>
void declare_view(Visitor& visitor, View& view) {
  visitor.field(required("eye", "where the observer stands"), view.eye, k_point);
  visitor.field(required("target", "a point in the middle of the picture"), view.target, k_point);
  visitor.field({"up", "direction that is up in the picture"}, view.up, k_point);
  visitor.field({"field_of_view", "vertical angle; or give a screen"}, view.field_of_view_deg,
                RealType{RealDimension::angle, {0.001, 179}});
  bool has_screen = view.screen.has_value();
  Screen screen = view.screen.value_or(Screen{});
  visitor.optional_group({"screen", "rectangle in front of the eye; or give a field_of_view"},
                         has_screen, [&] { declare_screen(visitor, screen); });
  if (has_screen) {
    view.screen = screen;
  }
}

template <class Visitor>
void declare_light(Visitor& visitor, Light& light) {
  visitor.field(required("position", "of the point source"), light.position, k_point);
  visitor.field({"intensity", "what a facing surface receives: red, green, blue"}, light.intensity,
                k_intensity);
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
  visitor.field({"tolerance", "of the roots that give a ray's hits, in ulps"}, roots.tolerance,
                RealType{RealDimension::number, {1, 1e6}});
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

/// Lights, surfaces and the object tree come besides: they are named or nested.
template <class Visitor>
void declare_scene(Visitor& visitor, Scene& scene) {
  visitor.field({"name", "of the scene"}, scene.name, TextType{});
  declare_paper_time(visitor, scene);
  visitor.group(required("view", "the observer"), [&] { declare_view(visitor, scene.view); });
  visitor.field({"ambient", "uniform light from everywhere: red, green, blue"}, scene.ambient,
                k_intensity);
  visitor.field({"background", "where no object is: red, green, blue"}, scene.background,
                k_intensity);
  visitor.field({"shadows", "lights are blocked by objects"}, scene.shadows, FlagType{});
  visitor.group({"ray_tree", "where the binary tree of rays ends"},
                [&] { declare_ray_tree(visitor, scene.ray_tree); });
  visitor.group({"roots", "how near numerical solutions come to the exact ones"},
                [&] { declare_roots(visitor, scene.roots); });
}

}  // namespace maquette::sim
