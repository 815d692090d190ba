#include "sim/run/pixel_sight.hpp"

#include <algorithm>

#include "firmware/synthesize.hpp"

namespace maquette::sim {

namespace {

using firmware::PendingRay;
using firmware::RayQuery;

/// Follows the rays as firmware::luminance does, and looks at those that wait.
int tree_depth(const firmware::Frame<float>& frame, const RayQuery<float>& primary,
               const firmware::WorkArea<float>& area) {
  firmware::Sight<float> sight;
  std::int32_t height = 0;
  int deepest = 0;
  PendingRay<float> pending{primary.ray, {1, 1, 1}, 0, firmware::k_void, firmware::k_no_node};
  RayQuery<float> query = primary;
  while (true) {
    const std::int32_t before = height;
    firmware::follow(frame, query, pending, area, height, sight);
    for (std::int32_t ray = before; ray < height; ++ray) {
      deepest = std::max(deepest, static_cast<int>(area.rays[ray].depth));
    }
    if (height == 0) {
      return deepest;
    }
    pending = area.rays[--height];
    query = {pending.ray, firmware::far_away<float>(), false,         0,
             0,           pending.left_behind,         pending.medium};
  }
}

}  // namespace

PixelSight pixel_sight(const firmware::Frame<float>& frame, const firmware::WorkArea<float>& area,
                       const models::PixelPosition& position) {
  const RayQuery<float> primary =
      firmware::primary_ray(frame.database, static_cast<std::int16_t>(position.column),
                            static_cast<std::int16_t>(position.row));
  PixelSight seen;
  seen.tree_depth = tree_depth(frame, primary, area);
  firmware::SurfaceIndex before = firmware::k_void;
  const std::int32_t count = firmware::cross_scene(frame, primary, area.crossings);
  const std::int32_t first = firmware::first_ahead(frame, primary, area.crossings, count, before);
  if (first == count || !(area.crossings[first].distance < firmware::far_away<float>())) {
    return seen;
  }
  const firmware::Crossing<float> crossing = area.crossings[first];
  const firmware::SurfacePoint<float> point =
      firmware::surface_point(frame, primary, crossing, before);
  seen.is_seen = true;
  seen.primitive = point.leaf;
  seen.surface = point.surface;
  seen.distance = crossing.distance * glm::length(primary.ray.direction);
  seen.normal = {point.normal.x, point.normal.y, point.normal.z};
  return seen;
}

}  // namespace maquette::sim
