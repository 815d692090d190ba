#pragma once

#include "firmware/direct_light.hpp"
#include "firmware/nearest.hpp"
#include "firmware/textures.hpp"

/// The binary tree of reflected and refracted rays (paper, section III.2, figure 3), walked with a
/// stack: a ray's weight says what share of its luminance reaches the pixel, so sums need no way
/// back.
namespace maquette::firmware {

/// A ray that waits to be cast.
template <class Real>
struct PendingRay {
  Ray<Real> ray;  ///< unit direction, or through the pixel for a primary ray
  Color<Real> weight;
  std::int16_t depth;     ///< secondary rays before it in a row, itself included
  SurfaceIndex medium;    ///< in which it starts
  NodeIndex left_behind;  ///< leaf whose outside it has just left, or k_no_node
};

/// What synthesis writes on: crossings of one ray and rays that wait. Sizes: work_area.hpp.
template <class Real>
struct WorkArea {
  Crossing<Real>* crossings;
  PendingRay<Real>* rays;
};

template <class Real>
bool is_visible(const Database<Real>& database, const Color<Real>& weight) {
  return larger(weight.x, larger(weight.y, weight.z)) >= database.minimum_weight;
}

/// Puts the reflected ray of a point on the stack when it counts for something; `reflected` is its
/// share of the parent's weight. Returns the new height.
template <class Real>
std::int32_t spawn_reflected(const Frame<Real>& frame, const SurfacePoint<Real>& point,
                             const View<Real>& view, const Color<Real>& weight, std::int16_t depth,
                             PendingRay<Real>* stack, std::int32_t height) {
  if (!is_visible(frame.database, weight)) {
    return height;
  }
  const Vector<Real> direction = point.normal * (constant<Real>(2) * view.cosine) - view.towards;
  stack[height] = {
      {departure(point), normalize(direction)}, weight, depth, point.before, left_behind(point)};
  WaitingRays<Real>::put(height, RayKind::reflected);
  returns_also<Real>(messages::k_pending_ray);
  return height + 1;
}

/// The same for the refracted ray. Snell: n T = D + (c - g) N, with g the transmitted cosine times
/// n.
template <class Real>
[[gnu::noinline]] std::int32_t spawn_refracted(const Frame<Real>& frame,
                                               const SurfacePoint<Real>& point,
                                               const View<Real>& view, Real transmitted_cosine,
                                               const Color<Real>& weight, std::int16_t depth,
                                               PendingRay<Real>* stack, std::int32_t height) {
  if (!is_visible(frame.database, weight)) {
    return height;
  }
  const Vector<Real> direction = point.normal * (view.cosine - transmitted_cosine) - view.towards;
  stack[height] = {{far_departure(point), normalize(direction)},
                   weight,
                   depth,
                   point.after,
                   far_left_behind(point)};
  WaitingRays<Real>::put(height, RayKind::refracted);
  returns_also<Real>(messages::k_pending_ray);
  return height + 1;
}

/// Puts the secondary rays of a specular point on the stack: the reflected one with F, behind a
/// transparent surface also the refracted one with 1 - F. Returns the new height.
template <class Real, class Count>
[[gnu::noinline]] std::int32_t spawn(const Frame<Real>& frame, const SurfacePoint<Real>& point,
                                     const View<Real>& view, const PendingRay<Real>& parent,
                                     PendingRay<Real>* stack, std::int32_t height,
                                     RayNumbers<Count>& rays) {
  const Surface<Real>& surface = frame.database.surfaces[point.surface];
  const auto depth = static_cast<std::int16_t>(parent.depth + 1);
  charge<Real>(Operation::load);
  const Color<Real> share = parent.weight * surface.specular;
  std::int32_t top = height;
  if (!surface.transparent) {
    const Color<Real> reflected = share * fresnel_factor(surface, view.cosine, view);
    top = spawn_reflected(frame, point, view, reflected, depth, stack, top);
    rays.reflected = static_cast<Count>(rays.reflected + static_cast<Count>(top - height));
    return top;
  }
  const DielectricBorder<Real> border = dielectric_border(view.cosine, view.index);
  top = spawn_reflected(frame, point, view, share * border.reflected, depth, stack, height);
  rays.reflected = static_cast<Count>(rays.reflected + static_cast<Count>(top - height));
  const std::int32_t reflected_top = top;
  top = spawn_refracted(frame, point, view, border.transmitted_cosine,
                        share * (constant<Real>(1) - border.reflected), depth, stack, top);
  rays.refracted = static_cast<Count>(rays.refracted + static_cast<Count>(top - reflected_top));
  return top;
}

/// What the rays of a pixel find besides its luminance.
template <class Real>
struct Sight {
  RayCountsOf<Real> rays{};
  Real depth = far_away<Real>();  ///< of the first visible point, where the scene needs it
};

/// What a ray contributes by its first visible point; its secondary rays go on the stack.
template <class Real>
Color<Real> follow(const Frame<Real>& frame, const RayQuery<Real>& query,
                   const PendingRay<Real>& pending, const WorkArea<Real>& area,
                   std::int32_t& height, Sight<Real>& sight) {
  const InFunction<Real> here(Function::photometry);
  charge<Real>(Operation::ray);
  const Database<Real>& database = frame.database;
  const std::int32_t count = cross_scene(frame, query, area.crossings);
  const InLeg<Real> leg(Stage::photometry, [&frame, &query, count] {
    return messages::of_photometry(frame, query, count);
  });
  SurfaceIndex before = k_void;
  const std::int32_t first = first_ahead(frame, query, area.crossings, count, before);
  if (first == count) {
    charge<Real>(Operation::load, 3);
    return pending.weight * database.background;
  }
  const Crossing<Real> crossing = area.crossings[first];
  if (database.needs.depth && query.is_primary) {
    sight.depth = crossing.distance;
  }
  PendingRay<Real> arriving = pending;
  if (before != k_void && database.surfaces[before].absorbing) {
    const Real travelled =
        crossing.distance * (query.is_primary ? length(query.ray.direction) : constant<Real>(1));
    arriving.weight *= transmitted_over(database.surfaces[before], travelled);
  }
  if (before != k_void && !(crossing.distance < far_away<Real>())) {
    charge<Real>(Operation::load, 3);
    return arriving.weight * database.background;  // matter of a half-space has no end
  }
  SurfacePoint<Real> point = surface_point(frame, query, crossing, before);
  if (database.needs.textured) {
    point.tint = tint_of(frame, point);
  }
  const Surface<Real>& surface = database.surfaces[point.surface];
  // A matt surface looks the same from everywhere.
  View<Real> view{};
  if (surface.transparent || surface.specular > constant<Real>(0)) {
    view = view_of(frame, point,
                   query.is_primary ? normalize(query.ray.direction) : query.ray.direction);
  }
  const Color<Real> seen =
      arriving.weight * direct_light(frame, point, view, area.crossings, sight.rays);
  if (database.needs.reflections && pending.depth < database.ray_depth &&
      surface.specular > constant<Real>(0)) {
    height = spawn(frame, point, view, arriving, area.rays, height, sight.rays);
  }
  return seen;
}

/// Luminance of a pixel: the primary ray through it and all that follows from it.
template <class Real>
Color<Real> luminance(const Frame<Real>& frame, const RayQuery<Real>& primary,
                      const WorkArea<Real>& area, Sight<Real>& sight) {
  const Real one = constant<Real>(1);
  std::int32_t height = 0;
  ++sight.rays.primary;
  Color<Real> sum = follow(frame, primary, {primary.ray, {one, one, one}, 0, k_void, k_no_node},
                           area, height, sight);
  while (height > 0) {
    charge<Real>(Operation::load, 10);
    const PendingRay<Real> pending = area.rays[--height];
    const InRay<Real> here(WaitingRays<Real>::at(height));
    const RayQuery<Real> query{pending.ray, far_away<Real>(),    false,         0,
                               0,           pending.left_behind, pending.medium};
    sum += follow(frame, query, pending, area, height, sight);
  }
  return sum;
}

}  // namespace maquette::firmware
