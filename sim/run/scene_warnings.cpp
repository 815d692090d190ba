#include "sim/run/scene_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/pixel_sight.hpp"

namespace maquette::sim {

namespace {

using firmware::Counted;
using firmware::Frame;
using firmware::RayQuery;

/// Whether opaque matter is around a point, as some lines through it agree.
bool is_enclosed(const Frame<Counted>& frame, const firmware::WorkArea<Counted>& area,
                 const firmware::Vector<Counted>& point) {
  constexpr float k_directions[][3] = {
      {0.36F, 0.48F, 0.8F}, {-0.8F, 0.36F, -0.48F}, {0.48F, -0.8F, 0.36F}};
  return std::all_of(std::begin(k_directions), std::end(k_directions), [&](const auto& along) {
    const firmware::Vector<Counted> direction{Counted(along[0]), Counted(along[1]),
                                              Counted(along[2])};
    const RayQuery<Counted> query{{point, direction}, firmware::far_away<Counted>(), false, 0, 0};
    const std::int32_t count = firmware::cross(frame, query, frame.database.root, area.crossings);
    firmware::SurfaceIndex medium = firmware::k_void;
    firmware::first_ahead(area.crossings, count, medium);
    return firmware::is_opaque(frame.database.surfaces, medium);
  });
}

bool shines(const Color& color) { return color != Color{0, 0, 0}; }

bool has_light(const Scene& scene) {
  return shines(scene.ambient) ||
         std::any_of(scene.lights.begin(), scene.lights.end(),
                     [](const Light& light) { return shines(light.intensity); }) ||
         std::any_of(scene.surfaces.begin(), scene.surfaces.end(), [](const Surface& surface) {
           return surface.ambient && shines(*surface.ambient);
         });
}

/// The pixels that meet a body, and those of them that are not black.
struct Seen {
  std::int64_t pixels = 0;
  std::int64_t lit = 0;
};

Seen seen_in(const Frame<float>& frame, const models::Picture& picture) {
  const models::PixelRectangle zone = useful_zone_of(frame);
  SynthesisArea<float> area(frame.database);
  Seen seen;
  for (int row = zone.row0; row < zone.row0 + zone.height; ++row) {
    for (int column = zone.column0; column < zone.column0 + zone.width; ++column) {
      if (pixel_sight(frame, area.view(), {column, row}).is_seen) {
        ++seen.pixels;
        seen.lit += picture.at(column, row) != 0 ? 1 : 0;
      }
    }
  }
  return seen;
}

}  // namespace

std::vector<SceneWarning> frame_warnings(const Scene& scene, const Frame<Counted>& frame) {
  std::vector<SceneWarning> warnings;
  SynthesisArea<Counted> area(frame.database);
  for (std::size_t i = 0; scene.shadows && i < scene.lights.size(); ++i) {
    if (is_enclosed(frame, area.view(), frame.prepared.light_positions[i])) {
      warnings.push_back({"lights." + scene.lights[i].name,
                          fmt::format("the light {} is inside an opaque body and lights nothing "
                                      "outside of it",
                                      scene.lights[i].name)});
    }
  }
  if (!has_light(scene)) {
    warnings.push_back({"lights", "nothing is lit: no light and no ambient light is above 0"});
  }
  if (useful_zone_of(frame).pixels() == 0) {
    warnings.push_back({"view", "no body is within the view: every pixel shows the background"});
  }
  firmware::reset_counted_work();
  return warnings;
}

std::optional<SceneWarning> time_warning(double likely_s) {
  constexpr double k_day_s = 86400;
  if (likely_s < k_day_s) {
    return std::nullopt;
  }
  return SceneWarning{"", fmt::format("a board will compute for about {:.2g} days, as a sample of "
                                      "pixels tells; fewer pixels or more processors take less",
                                      likely_s / k_day_s)};
}

std::optional<SceneWarning> picture_warning(const Scene& scene, const PictureFormat& format,
                                            std::uint32_t background,
                                            const models::Picture& picture) {
  const auto tells_nothing = [background](std::uint32_t rgb) {
    return rgb == background || rgb == 0;
  };
  if (!std::all_of(picture.pixels.begin(), picture.pixels.end(), tells_nothing)) {
    return std::nullopt;
  }
  const PreparedScene<float> prepared(packed_scene<float>(scene, format));
  if (useful_zone_of(prepared.frame()).pixels() == 0) {
    return std::nullopt;  // has been told before
  }
  const Seen seen = seen_in(prepared.frame(), picture);
  if (seen.pixels == 0) {
    return SceneWarning{"view", "no pixel meets a body: every pixel shows the background"};
  }
  if (seen.lit > 0) {
    return std::nullopt;
  }
  return SceneWarning{
      "lights",
      fmt::format("nothing is lit: the {} pixels that meet a body are black", seen.pixels)};
}

}  // namespace maquette::sim
