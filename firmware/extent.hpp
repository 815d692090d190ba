#pragma once

#include "firmware/prepared.hpp"

/// Extents of nodes and how operators combine them: a difference is bounded by its first operand,
/// an intersection by both (paper, section V.2.3.1.2).
namespace maquette::firmware {

template <class Real>
Vector<Real> lower(const Vector<Real>& a, const Vector<Real>& b) {
  return {smaller(a.x, b.x), smaller(a.y, b.y), smaller(a.z, b.z)};
}

template <class Real>
Vector<Real> higher(const Vector<Real>& a, const Vector<Real>& b) {
  return {larger(a.x, b.x), larger(a.y, b.y), larger(a.z, b.z)};
}

template <class Real>
Sphere<Real> sphere_of(const Vector<Real>& center, Real radius) {
  return {center, radius, radius * radius};
}

/// The sphere through the corners of a box.
template <class Real>
Sphere<Real> sphere_around(const Box<Real>& box) {
  const InFunction<Real> here(Function::spheres);
  const Real half = constant<Real>(0.5);
  return sphere_of((box.low + box.high) * half, length(box.high - box.low) * half);
}

/// The smallest sphere around two spheres.
template <class Real>
Sphere<Real> sphere_around(const Sphere<Real>& a, const Sphere<Real>& b) {
  const InFunction<Real> here(Function::spheres);
  const Vector<Real> apart = b.center - a.center;
  const Real distance = length(apart);
  if (distance + b.radius <= a.radius) {
    return a;
  }
  if (distance + a.radius <= b.radius) {
    return b;
  }
  const Real radius = (distance + a.radius + b.radius) * constant<Real>(0.5);
  // Neither sphere holds the other, hence distance > |a.radius - b.radius| >= 0.
  return sphere_of(a.center + apart * ((radius - a.radius) / distance), radius);
}

template <class Real>
const Sphere<Real>& smaller_sphere(const Sphere<Real>& a, const Sphere<Real>& b) {
  const InFunction<Real> here(Function::spheres);
  return b.radius < a.radius ? b : a;
}

constexpr Rectangle united(const Rectangle& a, const Rectangle& b) {
  if (a.is_empty()) {
    return b;
  }
  if (b.is_empty()) {
    return a;
  }
  return {smaller(a.first_column, b.first_column), larger(a.end_column, b.end_column),
          smaller(a.first_row, b.first_row), larger(a.end_row, b.end_row)};
}

constexpr Rectangle common(const Rectangle& a, const Rectangle& b) {
  return {larger(a.first_column, b.first_column), smaller(a.end_column, b.end_column),
          larger(a.first_row, b.first_row), smaller(a.end_row, b.end_row)};
}

/// Extent of the union of two nodes.
template <class Real>
Extent<Real> united(const Extent<Real>& a, const Extent<Real>& b) {
  Extent<Real> extent = a;
  extent.bounded = a.bounded && b.bounded;
  extent.transparent = a.transparent || b.transparent;
  extent.rectangle = united(a.rectangle, b.rectangle);
  if (extent.bounded) {
    extent.box = {lower(a.box.low, b.box.low), higher(a.box.high, b.box.high)};
    extent.sphere = smaller_sphere(sphere_around(a.sphere, b.sphere), sphere_around(extent.box));
  }
  return extent;
}

/// Extent of what two nodes have in common. Operands that do not meet leave a point.
template <class Real>
Extent<Real> common(const Extent<Real>& a, const Extent<Real>& b) {
  Extent<Real> extent = b.bounded ? b : a;
  extent.transparent = a.transparent || b.transparent;
  extent.rectangle = common(a.rectangle, b.rectangle);
  if (a.bounded && b.bounded) {
    const Vector<Real> low = higher(a.box.low, b.box.low);
    extent.box = {low, higher(low, lower(a.box.high, b.box.high))};
    extent.sphere = smaller_sphere(smaller_sphere(a.sphere, b.sphere), sphere_around(extent.box));
  }
  return extent;
}

/// Extent of the first node without the second.
template <class Real>
Extent<Real> without(const Extent<Real>& a, const Extent<Real>& b) {
  Extent<Real> extent = a;
  extent.transparent = a.transparent || b.transparent;
  return extent;
}

template <class Real>
Extent<Real> combined(BooleanOperator combination, const Extent<Real>& a, const Extent<Real>& b) {
  const InFunction<Real> here(Function::boxes);
  switch (combination) {
    case BooleanOperator::union_of:
      return united(a, b);
    case BooleanOperator::intersection:
      return common(a, b);
    case BooleanOperator::difference:
      break;
  }
  return without(a, b);
}

/// Whether the part of a ray of unit direction between 0 and `reach` may meet the sphere.
template <class Real>
bool meets(const Ray<Real>& ray, Real reach, const Sphere<Real>& sphere) {
  charge<Real>(Operation::sphere);
  const Vector<Real> to_center = sphere.center - ray.origin;
  const Real distance_squared = glm::dot(to_center, to_center);
  charge<Real>(Operation::load, 5);
  if (distance_squared <= sphere.radius_squared) {
    return true;
  }
  const Real along = glm::dot(to_center, ray.direction);
  if (along < constant<Real>(0) || along - sphere.radius > reach) {
    return false;
  }
  // The squares are off by some ulps, which their difference may not lose a body by.
  constexpr double k_rounding = 16 * static_cast<double>(std::numeric_limits<Real>::epsilon());
  return distance_squared * constant<Real>(1 - k_rounding) - along * along <= sphere.radius_squared;
}

}  // namespace maquette::firmware
