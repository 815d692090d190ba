#pragma once

#include "firmware/primitives/surface_map_table.hpp"
#include "firmware/textures/texture_place.hpp"

/// A picture laid on a primitive by the parameters of its own surface; texels are not blended.
namespace maquette::firmware::picture {

/// The texel in which a coordinate lies that is counted in texels, of so many that repeat.
template <class Real>
std::int32_t texel_of(Real coordinate, std::uint16_t count) {
  return to_integer(coordinate) % count;
}

template <class Real>
[[gnu::noinline]] Color<Real> color(const TexturePlace<Real>& place) {
  const Texture<Real>& texture = place.texture;
  const Leaf<Real>& leaf = place.database.leaves[place.leaf];
  const SurfacePlace<Real> on = surface_map_of<Real>(leaf.kind)(
      place.local, place.face, place.database.parameters + leaf.first_parameter);
  charge<Real>(Operation::load, 3);
  const std::int32_t column = texel_of(on.u * texture.columns_per_turn, texture.columns);
  const std::int32_t row = texel_of(on.v * texture.rows_per_turn, texture.rows);
  // Rows come from the top of the picture, where v is 1.
  const std::int32_t from_top = texture.rows - 1 - row;
  const std::uint8_t* texel =
      place.database.texels + texture.first_texel +
      static_cast<std::uint32_t>(from_top * texture.columns + column) * k_texel_bytes;
  charge<Real>(Operation::load, 4);
  const Real share = constant<Real>(1.0 / 255);
  return texture.colors[0] * Color<Real>(from_integer<Real>(texel[0]) * share,
                                         from_integer<Real>(texel[1]) * share,
                                         from_integer<Real>(texel[2]) * share);
}

/// What the table of textures lists.
struct Kind {
  static constexpr const char* k_name = "picture";
  static constexpr bool k_is_mapped = true;
  template <class Real>
  static constexpr auto k_color = color<Real>;
};

}  // namespace maquette::firmware::picture
