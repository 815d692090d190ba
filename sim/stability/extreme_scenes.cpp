#include "sim/stability/extreme_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "firmware/facets/facet_table.hpp"
#include "sim/scene/placement.hpp"
#include "sim/stability/random_cases.hpp"
#include "sim/stability/tally.hpp"
#include "sim/stability/trial_picture.hpp"
#include "sim/stability/trial_scene.hpp"

namespace maquette::sim {

namespace {

constexpr PictureFormat k_format{32, 24};

/// A scene driven to an extreme, and the picture that is made of it.
struct Extreme {
  const char* name;
  void (*apply)(Scene& scene);
  PictureFormat format = k_format;
  int stride = 1;
};

void stretch(Scene& scene, const Vector3& scale) {
  scene.object.placement = concatenated(trial::scaled(scale), scene.object.placement);
}

void set_index(Scene& scene, double index) {
  for (Surface& surface : scene.surfaces) {
    surface.index = surface.metal ? surface.index : Color(index);
  }
}

void set_roughness(Scene& scene, firmware::FacetKind facets, double half_angle_deg) {
  for (Surface& surface : scene.surfaces) {
    surface.facets = facets;
    surface.half_angle_deg = half_angle_deg;
    surface.specular = std::fmax(surface.specular, 0.5);
  }
}

/// Rays that follow one another up to the 64th, as far as they count.
void deepen(Scene& scene) { scene.ray_tree = {64, 1.0 / 1024}; }

void make_glass(Scene& scene) {
  for (Surface& surface : scene.surfaces) {
    surface.metal = false;
    surface.transparent = true;
    surface.specular = 1;
    surface.index = Color(1.5);
  }
}

void make_mirrors(Scene& scene) {
  for (Surface& surface : scene.surfaces) {
    surface.transparent = false;
    surface.absorption = Color(0);
    surface.metal = true;
    surface.specular = 1;
    surface.index = Color(0.1);
    surface.extinction = Color(100);
  }
}

/// The point on the middle ray at a share of the way from where it enters the scene's matter (0) to
/// where it leaves it (1); the target where it meets nothing.
Vector3 point_in_matter(const Scene& scene, double share) {
  const PreparedScene<double> prepared(packed_scene<double>(scene, {1, 1}));
  SynthesisArea<double> area(prepared.frame().database);
  const auto ray = firmware::primary_ray(prepared.frame().database, 0, 0);
  const firmware::Crossing<double>* crossings = area.view().crossings;
  const std::int32_t count =
      firmware::cross(prepared.frame(), ray, prepared.frame().database.root, area.view().crossings);
  if (count < 2 || crossings[1].distance >= firmware::far_away<double>()) {
    return scene.view.target;
  }
  const double way =
      crossings[0].distance + share * (crossings[1].distance - crossings[0].distance);
  return scene.view.eye + glm::normalize(scene.view.target - scene.view.eye) * way;
}

/// Moves the eye along the middle ray, the direction of the view unchanged.
void move_eye(Scene& scene, const Vector3& eye) {
  const Vector3 direction = scene.view.target - scene.view.eye;
  scene.view.eye = eye;
  scene.view.target = eye + direction;
}

void move_lights(Scene& scene, const Vector3& position) {
  for (Light& light : scene.lights) {
    light.position = position;
  }
}

constexpr double k_thin = 1e-6;
/// The least and the largest half angle of a scene.
constexpr double k_half_angles_deg[] = {0.01, 89};

const Extreme k_extremes[] = {
    {"flat, 1e-6 along z",
     [](Scene& s) {
       stretch(s, {1, 1, k_thin});
     }},
    {"flat, 1e-6 along x",
     [](Scene& s) {
       stretch(s, {k_thin, 1, 1});
     }},
    {"needle, 1e-6 across z",
     [](Scene& s) {
       stretch(s, {k_thin, k_thin, 1});
     }},
    {"needle, 1e6 along y",
     [](Scene& s) {
       stretch(s, {1, 1 / k_thin, 1});
     }},
    {"index 1", [](Scene& s) { set_index(s, 1); }},
    {"index 10", [](Scene& s) { set_index(s, 10); }},
    {"index 0.1, total reflection from outside", [](Scene& s) { set_index(s, 0.1); }},
    {"ray tree of depth 64", deepen},
    {"all of glass, depth 64",
     [](Scene& s) {
       make_glass(s);
       deepen(s);
     }},
    {"all of glass of index 10, eye inside",
     [](Scene& s) {
       move_eye(s, point_in_matter(s, 0.5));
       make_glass(s);
       set_index(s, 10);
     }},
    {"all mirrors, depth 64",
     [](Scene& s) {
       make_mirrors(s);
       deepen(s);
     }},
    {"eye inside of matter", [](Scene& s) { move_eye(s, point_in_matter(s, 0.5)); }},
    {"eye on a surface", [](Scene& s) { move_eye(s, point_in_matter(s, 0)); }},
    {"lights on a surface", [](Scene& s) { move_lights(s, point_in_matter(s, 0)); }},
    {"lights inside of matter", [](Scene& s) { move_lights(s, point_in_matter(s, 0.5)); }},
    {"lights at the eye", [](Scene& s) { move_lights(s, s.view.eye); }},
    {"frame of 1 x 1", [](Scene& /*s*/) {}, {1, 1}},
    {"frame of 8192 x 8192, each 64th", [](Scene& /*s*/) {}, {8192, 8192}, 64},
    {"frame of 8192 x 1, each 8th", [](Scene& /*s*/) {}, {8192, 1}, 8},
    {"frame of 1 x 8192, each 8th", [](Scene& /*s*/) {}, {1, 8192}, 8},
};

struct ExtremeTally {
  int unsound = 0;

  void operator+=(const ExtremeTally& other) { unsound += other.unsound; }
};

/// How all scenes fare when driven to one extreme.
template <class Real, class Apply>
StabilityRow extreme_row(const std::vector<ShippedScene>& scenes, const std::string& name,
                         const Apply& apply, const PictureFormat& format = k_format,
                         int stride = 1) {
  const auto add = [&](int number, ExtremeTally& tally) {
    Scene scene = scenes[static_cast<std::size_t>(number)].scene;
    apply(scene);
    const PreparedScene<Real> prepared(packed_scene<Real>(scene, format));
    tally.unsound += trial_picture(prepared, stride).unsound;
  };
  const auto tally = tally_over<ExtremeTally>(static_cast<int>(scenes.size()), add);
  return {"extreme", name, "pixels without a luminance", 1.0 * tally.unsound, 0};
}

}  // namespace

template <class Real>
std::vector<StabilityRow> extreme_scene_rows(const std::vector<ShippedScene>& scenes) {
  std::vector<StabilityRow> rows;
  for (const Extreme& extreme : k_extremes) {
    rows.push_back(
        extreme_row<Real>(scenes, extreme.name, extreme.apply, extreme.format, extreme.stride));
  }
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    for (const double half_angle_deg : k_half_angles_deg) {
      const auto facets = static_cast<firmware::FacetKind>(kind);
      rows.push_back(extreme_row<Real>(
          scenes,
          fmt::format("{} of {} deg", firmware::distribution_of(facets).title, half_angle_deg),
          [&](Scene& scene) { set_roughness(scene, facets, half_angle_deg); }));
    }
  }
  return rows;
}

template std::vector<StabilityRow> extreme_scene_rows<float>(const std::vector<ShippedScene>&);
template std::vector<StabilityRow> extreme_scene_rows<double>(const std::vector<ShippedScene>&);

}  // namespace maquette::sim
