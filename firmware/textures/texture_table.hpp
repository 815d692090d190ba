#pragma once

#include "firmware/kind_list.hpp"
#include "firmware/textures/bands.hpp"
#include "firmware/textures/checker.hpp"
#include "firmware/textures/picture.hpp"
#include "firmware/textures/rings.hpp"

namespace maquette::firmware {

/// The table of textures: each is one row here, all else in the header of its name.
using TextureKinds = KindList<checker::Kind, bands::Kind, rings::Kind, picture::Kind>;

inline constexpr int k_texture_kind_count = TextureKinds::k_count;
static_assert(k_texture_kind_count <= k_texture_kind_limit);

/// What is known of a texture besides its colours.
struct TextureDescription {
  const char* name;  ///< in scenes, and its namespace here
  bool is_mapped;    ///< by the parameters of a primitive's surface: a picture
};

struct TextureTable {
  TextureDescription rows[k_texture_kind_count];
};

template <class... Kinds>
constexpr TextureTable texture_table(KindList<Kinds...> /*kinds*/) {
  return {{{Kinds::k_name, Kinds::k_is_mapped}...}};
}

inline constexpr TextureTable k_textures = texture_table(TextureKinds{});

/// The kind of a texture, e.g. texture_kind_of<rings::Kind>.
template <class Kind>
inline constexpr auto texture_kind_of =
    static_cast<TextureKind>(PlaceIn<Kind, TextureKinds>::k_value);

template <class Real, class Last>
Color<Real> texture_color(KindList<Last> /*kinds*/, const TexturePlace<Real>& place) {
  return Last::template k_color<Real>(place);
}

/// What a texture of one of a list shows at a place.
template <class Real, class First, class Second, class... Others>
Color<Real> texture_color(KindList<First, Second, Others...> /*kinds*/,
                          const TexturePlace<Real>& place) {
  if (place.texture.kind == texture_kind_of<First>) {
    return First::template k_color<Real>(place);
  }
  return texture_color(KindList<Second, Others...>{}, place);
}

}  // namespace maquette::firmware
