#pragma once

#include "firmware/textures/texture_place.hpp"

/// Layers of two colours in turn along the x axis.
namespace maquette::firmware::bands {

template <class Real>
[[gnu::noinline]] Color<Real> color(const TexturePlace<Real>& place) {
  return cell_color(place.texture, cell_of(pattern_point(place).x));
}

/// What the table of textures lists.
struct Kind {
  static constexpr const char* k_name = "bands";
  static constexpr bool k_is_mapped = false;
  template <class Real>
  static constexpr auto k_color = color<Real>;
};

}  // namespace maquette::firmware::bands
