#pragma once

#include "firmware/arithmetic/elementary.hpp"
#include "firmware/depth.hpp"
#include "firmware/extent.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "firmware/projection.hpp"

/// The phase before synthesis, done by every board (paper, section V.2.3.1.2): concatenated
/// transforms and their inverses, box and sphere extents, projected rectangles, useful zone.
namespace maquette::firmware {

namespace preprocessing {

/// Rectangles and extents grow by this many ulps of the number type times the coordinates they
/// were computed from: more than the rounding of a transform and a projection.
inline constexpr double k_extent_margin = 32;

/// Crossings closer than this many ulps times the coordinates they were computed from are one:
/// their rounding across a surface.
inline constexpr double k_crossing_tolerance = 4;

/// A ray that grazes faces sees them up to this many times as far apart as they are.
inline constexpr double k_grazing = 512;

template <class Real>
Rectangle whole_screen(const Observer<Real>& observer) {
  return {0, static_cast<std::int16_t>(observer.columns), 0,
          static_cast<std::int16_t>(observer.rows)};
}

/// A coordinate of the screen, clamped to 0 .. end.
template <class Real>
std::int16_t clamped_index(Real value, std::int32_t end) {
  const Real limit = from_integer<Real>(end);
  const Real inside = larger(constant<Real>(0), smaller(value, limit));
  return static_cast<std::int16_t>(to_integer(inside));
}

/// One of the eight corners of a box, in another frame.
template <class Real>
Vector<Real> corner_of(const Box<Real>& box, int corner, const Affine<Real>& frame) {
  return transform_point(frame, Vector<Real>((corner & 1) != 0 ? box.high.x : box.low.x,
                                             (corner & 2) != 0 ? box.high.y : box.low.y,
                                             (corner & 4) != 0 ? box.high.z : box.low.z));
}

/// The pixels that the parallelepiped of a local box may cover: the rectangle around its projected
/// corners. In perspective the whole screen when a corner lies beside or behind the eye.
template <Projection projection, class Real>
Rectangle projected(const Box<Real>& local, const Affine<Real>& to_screen, Real scale,
                    const Observer<Real>& observer) {
  const InFunction<Real> here(Function::rectangles);
  const Real margin = scale * ulps<Real>(k_extent_margin);
  Real left = far_away<Real>();
  Real right = -left;
  Real bottom = left;
  Real top = -left;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector<Real> p = corner_of(local, corner, to_screen);
    if constexpr (projection == Projection::parallel) {
      left = smaller(left, p.x - margin);
      right = larger(right, p.x + margin);
      bottom = smaller(bottom, p.y - margin);
      top = larger(top, p.y + margin);
      continue;
    }
    const Real depth = p.z - margin;
    if (!(depth > margin)) {
      return whole_screen(observer);
    }
    const Real inverse = constant<Real>(1) / depth;
    const Real x = p.x * inverse;
    const Real y = p.y * inverse;
    left = smaller(left, x);
    right = larger(right, x);
    bottom = smaller(bottom, y);
    top = larger(top, y);
  }
  // A pixel on either side covers the division by a depth that is short by the margin, and the half
  // of one by which the outermost of several rays of a pixel lie off its centre.
  const Real one = constant<Real>(1);
  const Real two = constant<Real>(2);
  const Real inverse_step = one / observer.step;
  const Real widen = one + ulps<Real>(k_extent_margin);
  return {clamped_index(((left - observer.left) * inverse_step) * widen - one, observer.columns),
          clamped_index(((right - observer.left) * inverse_step) * widen + two, observer.columns),
          clamped_index(((observer.top - top) * inverse_step) * widen - one, observer.rows),
          clamped_index(((observer.top - bottom) * inverse_step) * widen + two, observer.rows)};
}

/// Bound of how much the linear part of a frame stretches a vector: the root of the largest row sum
/// of M^T M, exact when the axes are perpendicular.
template <class Real>
Real stretch(const Affine<Real>& frame) {
  Real largest = constant<Real>(0);
  for (int row = 0; row < 3; ++row) {
    const Real sum = absolute(glm::dot(frame[row], frame[0])) +
                     absolute(glm::dot(frame[row], frame[1])) +
                     absolute(glm::dot(frame[row], frame[2]));
    largest = larger(largest, sum);
  }
  return square_root(largest);
}

/// Radius of the sphere around a local box's centre that holds the primitive in the screen frame.
template <class Real>
Real radius_of(PrimitiveKind kind, const Box<Real>& local, const Affine<Real>& to_screen,
               const Vector<Real>& center) {
  const InFunction<Real> here(Function::spheres);
  if (fits_unit_ball(kind, Primitives{})) {
    return stretch(to_screen);
  }
  Real radius = constant<Real>(0);
  for (int corner = 0; corner < 8; ++corner) {
    radius = larger(radius, length(corner_of(local, corner, to_screen) - center));
  }
  return radius;
}

template <class Real>
Box<Real> box_around(const Box<Real>& local, const Affine<Real>& to_screen) {
  Box<Real> box;
  box.low = box.high = corner_of(local, 0, to_screen);
  for (int corner = 1; corner < 8; ++corner) {
    const Vector<Real> p = corner_of(local, corner, to_screen);
    box = {lower(box.low, p), higher(box.high, p)};
  }
  return box;
}

template <class Real>
PreparedLeaf<Real> prepared_leaf(const Leaf<Real>& leaf, const Observer<Real>& observer) {
  const InFunction<Real> here(Function::concatenation);
  PreparedLeaf<Real> prepared;
  prepared.to_screen = concatenate(observer.to_screen, leaf.to_scene);
  prepared.from_screen = concatenate(leaf.from_scene, observer.from_screen);
  prepared.scale = magnitude(prepared.to_screen[3]) + stretch(prepared.to_screen);
  return prepared;
}

template <class Real>
Extent<Real> leaf_extent(const Database<Real>& database, const Leaf<Real>& leaf,
                         const PreparedLeaf<Real>& prepared) {
  const InFunction<Real> here(Function::boxes);
  Extent<Real> extent{};
  Box<Real> local{};
  extent.bounded =
      primitive_of<Real>(leaf.kind).bounds(database.parameters + leaf.first_parameter, local);
  extent.transparent = database.surfaces[leaf.surface].transparent;
  if (!extent.bounded) {
    extent.rectangle = whole_screen(database.observer);
    return extent;
  }
  const Real margin = prepared.scale * ulps<Real>(k_extent_margin);
  const Vector<Real> margins(margin, margin, margin);
  const Vector<Real> center =
      transform_point(prepared.to_screen, (local.low + local.high) * constant<Real>(0.5));
  const Box<Real> box = box_around(local, prepared.to_screen);
  extent.box = {box.low - margins, box.high + margins};
  extent.sphere =
      sphere_of(center, radius_of(leaf.kind, local, prepared.to_screen, center) + margin);
  extent.rectangle = is_parallel(database)
                         ? projected<Projection::parallel>(local, prepared.to_screen,
                                                           prepared.scale, database.observer)
                         : projected<Projection::perspective>(local, prepared.to_screen,
                                                              prepared.scale, database.observer);
  return extent;
}

template <class Real>
void prepare_nodes(const Database<Real>& database, Prepared<Real>& prepared) {
  Real largest = constant<Real>(0);
  for (NodeIndex node = 0; node < database.leaf_count; ++node) {
    const Leaf<Real>& leaf = database.leaves[node];
    prepared.leaves[node] = prepared_leaf(leaf, database.observer);
    prepared.extents[node] = leaf_extent(database, leaf, prepared.leaves[node]);
    largest = larger(largest, prepared.leaves[node].scale);
  }
  for (NodeIndex node = database.leaf_count; node < database.node_count(); ++node) {
    const Composite& composite = database.composite(node);
    prepared.extents[node] =
        combined(composite.combination, prepared.extents[composite.children[0]],
                 prepared.extents[composite.children[1]]);
  }
  // Inside the scene no distance exceeds four times the largest coordinate.
  prepared.coarse_tolerance = largest * ulps<Real>(6 * k_grazing * k_crossing_tolerance);
}

/// The ambient light that surfaces have besides that of the scene.
template <class Real>
[[gnu::noinline]] void add_surface_ambients(const Database<Real>& database,
                                            Prepared<Real>& prepared) {
  for (SurfaceIndex index = 0; index < database.surface_count; ++index) {
    const Surface<Real>& surface = database.surfaces[index];
    prepared.surfaces[index].ambient +=
        surface.diffuse * (constant<Real>(1) - surface.specular) * database.surface_ambients[index];
  }
}

template <class Real>
[[gnu::noinline]] void prepare_light_axes(const Database<Real>& database,
                                          Prepared<Real>& prepared) {
  for (std::uint16_t light = 0; light < database.light_count; ++light) {
    prepared.light_axes[light] =
        transform_direction(database.observer.to_screen, database.light_shapes[light].axis);
  }
}

template <class Real>
[[gnu::noinline]] void prepare_surfaces(const Database<Real>& database, Prepared<Real>& prepared) {
  const Real inverse_pi = constant<Real>(1 / elementary::k_pi);
  for (SurfaceIndex index = 0; index < database.surface_count; ++index) {
    const Surface<Real>& surface = database.surfaces[index];
    const Color<Real> share = surface.diffuse * (constant<Real>(1) - surface.specular);
    prepared.surfaces[index] = {share * inverse_pi, share * database.ambient};
  }
}

}  // namespace preprocessing

/// Fills `prepared`, whose arrays the caller provides, from the database. The useful zone is the
/// rectangle of the root.
template <class Real>
void preprocess(const Database<Real>& database, Prepared<Real>& prepared) {
  const InFunction<Real> here(Function::preparation);
  preprocessing::prepare_nodes(database, prepared);
  if (database.needs.diffuse) {
    preprocessing::prepare_surfaces(database, prepared);
  }
  if (database.needs.surface_ambient) {
    preprocessing::add_surface_ambients(database, prepared);
  }
  for (std::uint16_t light = 0; light < database.light_count; ++light) {
    prepared.light_positions[light] =
        transform_point(database.observer.to_screen, database.lights[light].position);
  }
  if (database.needs.shaped_lights) {
    preprocessing::prepare_light_axes(database, prepared);
  }
  if (database.needs.depth) {
    prepared.depths = depth_range(database, prepared.extents);
  }
  prepared.useful_zone = prepared.extents[database.root].rectangle;
}

}  // namespace maquette::firmware
