#pragma once

#include "firmware/surface_point.hpp"
#include "firmware/textures/texture_table.hpp"

/// What the texture of a surface shows at a point.
namespace maquette::firmware {

/// The factors by which the texture at a point multiplies the reflectance of the surface. Where the
/// surface seen is not the leaf's own, as on a cut through transparent matter, there is none.
template <class Real>
[[gnu::noinline]] Color<Real> tint_of(const Frame<Real>& frame, const SurfacePoint<Real>& point) {
  const Database<Real>& database = frame.database;
  const Real one = constant<Real>(1);
  const std::uint16_t number = database.leaf_textures[point.leaf];
  const Leaf<Real>& leaf = database.leaves[point.leaf];
  charge<Real>(Operation::load);
  if (number == k_no_texture || point.surface != leaf.surface) {
    return {one, one, one};
  }
  const Vector<Real> local =
      transform_point(frame.prepared.leaves[point.leaf].from_screen, point.position);
  const TexturePlace<Real> place{database, database.textures[number], local, point.leaf,
                                 point.face};
  return texture_color(TextureKinds{}, place);
}

}  // namespace maquette::firmware
