#pragma once

#include "firmware/textures/texture_place.hpp"

/// Rings of two colours in turn around the z axis.
namespace maquette::firmware::rings {

template <class Real>
[[gnu::noinline]] Color<Real> color(const TexturePlace<Real>& place) {
  const Vector<Real> at = pattern_point(place);
  return cell_color(place.texture, cell_of(square_root(at.x * at.x + at.y * at.y)));
}

/// What the table of textures lists.
struct Kind {
  static constexpr const char* k_name = "rings";
  static constexpr bool k_is_mapped = false;
  template <class Real>
  static constexpr auto k_color = color<Real>;
};

}  // namespace maquette::firmware::rings
