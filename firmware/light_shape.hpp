#pragma once

#include "firmware/prepared.hpp"

/// Light sources that are not alike everywhere: near ones, whose light falls off with the square of
/// the distance (what the paper's approximation of remote sources leaves out, section III.1), and
/// spots.
namespace maquette::firmware {

/// Share of a source's intensity that a point receives. `to_light` is the unit vector towards the
/// source.
template <class Real>
[[gnu::noinline]] Real shaped_share(const Frame<Real>& frame, std::uint16_t light,
                                    const Vector<Real>& to_light, Real distance) {
  const LightShape<Real>& shape = frame.database.light_shapes[light];
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  charge<Real>(Operation::load, 2);
  Real share = one;
  if (shape.per_cosine > zero) {
    charge<Real>(Operation::load, 4);
    const Real cosine = -glm::dot(frame.prepared.light_axes[light], to_light);
    const Real inside = smaller(one, (cosine - shape.edge_cosine) * shape.per_cosine);
    if (!(inside > zero)) {
      return zero;
    }
    share = inside * inside * (constant<Real>(3) - (inside + inside));
  }
  if (shape.reference_squared > zero) {
    share *= shape.reference_squared / (distance * distance);
  }
  return share;
}

}  // namespace maquette::firmware
