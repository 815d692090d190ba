#pragma once

#include "firmware/textures/texture_place.hpp"

/// Cubes of two colours in turn along all three axes.
namespace maquette::firmware::checker {

template <class Real>
[[gnu::noinline]] Color<Real> color(const TexturePlace<Real>& place) {
  const Vector<Real> at = pattern_point(place);
  return cell_color(place.texture, cell_of(at.x) + cell_of(at.y) + cell_of(at.z));
}

/// What the table of textures lists.
struct Kind {
  static constexpr const char* k_name = "checker";
  static constexpr bool k_is_mapped = false;
  template <class Real>
  static constexpr auto k_color = color<Real>;
};

}  // namespace maquette::firmware::checker
