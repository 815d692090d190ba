#include "sim/stability/scene_scale.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/stability/tally.hpp"
#include "sim/stability/trial_picture.hpp"

namespace maquette::sim {

namespace {

/// Powers of ten from 1e-5 to 1e5 but 1, and two powers of two.
constexpr double k_scales[] = {1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1e1, 1e2, 1e3, 1e4, 1e5};
constexpr int k_scale_count = 10;
constexpr double k_exact_scales[] = {1.0 / 131072, 131072};

/// The most pixels whose centres lie so near to an edge that rounding decides on which side: a
/// tenth of the picture is edges, and a ray's place is known to some ulps of the screen, which grow
/// where it grazes. The expected number and three standard deviations of so rare a thing.
template <class Real>
double most_ties(const PictureFormat& format) {
  constexpr double k_edge_share = 0.1;
  constexpr double k_ulps = 32;
  const double band = 2 * k_ulps * std::numeric_limits<Real>::epsilon() * format.width;
  const double expected = k_edge_share * format.width * format.height * band;
  return std::floor(expected + 3 * std::sqrt(expected));
}

Placement scaled(Placement placement, double scale) {
  for (int column = 0; column < 4; ++column) {
    placement[column] *= scale;
  }
  return placement;
}

struct ScaleTally {
  int worst = 0;
  int unsound = 0;

  void operator+=(const ScaleTally& other) {
    worst = std::max(worst, other.worst);
    unsound += other.unsound;
  }
};

}  // namespace

Scene scaled(Scene scene, double scale) {
  scene.view.eye *= scale;
  scene.view.target *= scale;
  if (scene.view.height) {
    *scene.view.height *= scale;
  }
  if (std::optional<Screen>& screen = scene.view.screen; screen && screen->placement) {
    *screen->placement = scaled(*screen->placement, scale);
  } else if (screen) {
    screen->distance *= scale;
    screen->width *= scale;
    screen->height *= scale;
  }
  for (Light& light : scene.lights) {
    light.placement = scaled(light.placement.value_or(Placement(1.0)), scale);
    if (light.falloff) {
      *light.falloff *= scale;
    }
  }
  for (Surface& surface : scene.surfaces) {
    surface.absorption /= scale;
  }
  scene.object.placement = scaled(scene.object.placement, scale);
  return scene;
}

template <class Real>
std::vector<StabilityRow> scale_rows(const ShippedScene& shipped, int width) {
  const PictureFormat format{width, width * 3 / 4};
  const TrialPicture original = trial_picture<Real>(shipped.scene, format);
  const auto add = [&](double scale, int levels, ScaleTally& tally) {
    const TrialPicture other = trial_picture<Real>(scaled(shipped.scene, scale), format);
    tally.worst = std::max(tally.worst, differing_pixels(original, other, levels));
    tally.unsound += other.unsound;
  };
  const auto rounded = tally_over<ScaleTally>(
      k_scale_count, [&](int number, ScaleTally& tally) { add(k_scales[number], 1, tally); });
  ScaleTally exact;
  for (const double scale : k_exact_scales) {
    add(scale, 0, exact);
  }
  return {{"scale", shipped.name, "pixels off by more than one level, 1e-5 to 1e5",
           1.0 * rounded.worst, most_ties<Real>(format)},
          {"scale", shipped.name, "pixels off at powers of two", 1.0 * exact.worst, 0},
          {"scale", shipped.name, "pixels without a luminance",
           1.0 * (original.unsound + rounded.unsound + exact.unsound), 0}};
}

template std::vector<StabilityRow> scale_rows<float>(const ShippedScene& shipped, int width);
template std::vector<StabilityRow> scale_rows<double>(const ShippedScene& shipped, int width);

}  // namespace maquette::sim
