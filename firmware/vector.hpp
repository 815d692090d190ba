#pragma once

#include <glm/geometric.hpp>
#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include "firmware/arithmetic/real.hpp"

namespace maquette::firmware {

template <class Real>
using Vector = glm::vec<3, Real, glm::defaultp>;

/// Red, green, blue; linear.
template <class Real>
using Color = glm::vec<3, Real, glm::defaultp>;

/// A change of frame: three columns for the axes, the fourth for the origin.
template <class Real>
using Affine = glm::mat<4, 3, Real, glm::defaultp>;

template <class Real>
struct Ray {
  Vector<Real> origin;
  Vector<Real> direction;
};

/// Image of a direction.
template <class Real>
Vector<Real> transform_direction(const Affine<Real>& frame, const Vector<Real>& v) {
  charge<Real>(Operation::load, 9);
  return frame[0] * v.x + frame[1] * v.y + frame[2] * v.z;
}

/// Image of a point.
template <class Real>
Vector<Real> transform_point(const Affine<Real>& frame, const Vector<Real>& v) {
  charge<Real>(Operation::load, 3);
  return transform_direction(frame, v) + frame[3];
}

/// Image of a surface's normal under the change of frame whose inverse is given: the transpose of
/// the inverse. Not of unit length.
template <class Real>
Vector<Real> transform_normal(const Affine<Real>& inverse, const Vector<Real>& normal) {
  charge<Real>(Operation::load, 9);
  return {glm::dot(inverse[0], normal), glm::dot(inverse[1], normal), glm::dot(inverse[2], normal)};
}

/// The frame `inner` seen through `outer`: first inner, then outer.
template <class Real>
Affine<Real> concatenate(const Affine<Real>& outer, const Affine<Real>& inner) {
  Affine<Real> result;
  for (int column = 0; column < 3; ++column) {
    result[column] = transform_direction(outer, inner[column]);
  }
  result[3] = transform_point(outer, inner[3]);
  return result;
}

template <class Real>
Real length(const Vector<Real>& v) {
  return square_root(glm::dot(v, v));
}

/// The vector in unit length; the zero vector stays zero.
template <class Real>
Vector<Real> normalize(const Vector<Real>& v) {
  return v * saturated_inverse(length(v));
}

/// Largest magnitude of the three components.
template <class Real>
Real magnitude(const Vector<Real>& v) {
  return larger(absolute(v.x), larger(absolute(v.y), absolute(v.z)));
}

}  // namespace maquette::firmware
