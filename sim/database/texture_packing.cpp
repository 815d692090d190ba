#include "sim/database/texture_packing.hpp"

#include <glm/common.hpp>
#include <map>
#include <string>

#include "firmware/primitives/surface_map_table.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "sim/scene/placement.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

/// A colour over a larger one; where that is black so is the colour.
Color share_of(const Color& color, const Color& whole) {
  Color share(1, 1, 1);
  for (int i = 0; i < 3; ++i) {
    share[i] = whole[i] > 0 ? color[i] / whole[i] : 1;
  }
  return share;
}

/// The frame of the leaf to that of the pattern, in which a cell is one unit wide.
Placement to_pattern(const Texture& texture, const TreeLeaf& leaf) {
  const Placement& frame =
      texture.frame == TextureFrame::primitive ? leaf.own_frame : leaf.surface_frame;
  const Placement placed = texture.placement ? concatenated(frame, *texture.placement) : frame;
  const Placement cells = scaled_and_raised(Vector3(texture.size), 0);
  return concatenated(inverse_of(concatenated(placed, cells)), leaf.to_scene);
}

firmware::Texture<double> pattern_of(const Surface& surface, const TreeLeaf& leaf) {
  const Texture& texture = *surface.texture;
  const Color whole = packed_diffuse(surface);
  firmware::Texture<double> packed{};
  packed.kind = kind_of(texture);
  packed.from_leaf = to_pattern(texture, leaf);
  packed.colors[0] = share_of(surface.diffuse, whole);
  packed.colors[1] = share_of(texture.color, whole);
  return packed;
}

firmware::Texture<double> picture_of(const Texture& texture, std::vector<std::uint8_t>& texels) {
  const TexturePicture& picture = *texture.picture;
  firmware::Texture<double> packed{};
  packed.kind = kind_of(texture);
  packed.from_leaf = Placement(1.0);
  packed.colors[0] = packed.colors[1] = Color(1, 1, 1);
  packed.columns = static_cast<std::uint16_t>(picture.columns);
  packed.rows = static_cast<std::uint16_t>(picture.rows);
  packed.columns_per_turn = picture.columns * texture.repeat_u;
  packed.rows_per_turn = picture.rows * texture.repeat_v;
  packed.first_texel = static_cast<std::uint32_t>(texels.size());
  texels.insert(texels.end(), picture.texels.begin(), picture.texels.end());
  return packed;
}

void check_map(const Surface& surface, const TreeLeaf& leaf) {
  if (firmware::surface_map_of<double>(leaf.kind) == nullptr) {
    throw DescriptionError(surface.position_in_file,
                           "texture: a " + std::string{description_of(leaf.kind).name} +
                               " has no parameters to lay a picture by; a pattern is allowed");
  }
}

}  // namespace

firmware::TextureKind kind_of(const Texture& texture) {
  return texture.pattern.value_or(firmware::texture_kind_of<firmware::picture::Kind>);
}

Color packed_diffuse(const Surface& surface) {
  return surface.texture && surface.texture->pattern
             ? glm::max(surface.diffuse, surface.texture->color)
             : surface.diffuse;
}

PackedTextures packed_textures(const Scene& scene, const ObjectTree& tree) {
  PackedTextures packed;
  std::map<std::size_t, std::uint16_t> pictures;  // by their surfaces
  for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
    const TreeLeaf& leaf = tree.leaves[i];
    const Surface& surface = scene.surfaces[leaf.surface];
    if (!surface.texture) {
      continue;
    }
    packed.of_leaves.resize(tree.leaves.size(), firmware::k_no_texture);
    const auto next = static_cast<std::uint16_t>(packed.textures.size());
    if (surface.texture->picture) {
      check_map(surface, leaf);
      const auto [known, is_new] = pictures.emplace(leaf.surface, next);
      packed.of_leaves[i] = known->second;
      if (!is_new) {
        continue;
      }
      packed.textures.push_back(picture_of(*surface.texture, packed.texels));
    } else {
      packed.of_leaves[i] = next;
      packed.textures.push_back(pattern_of(surface, leaf));
    }
    if (next == firmware::k_no_texture - 1) {
      throw DescriptionError(surface.position_in_file,
                             "texture: more than " + std::to_string(firmware::k_no_texture - 1) +
                                 " primitives have one; `frame: object` shares none");
    }
  }
  return packed;
}

}  // namespace maquette::sim
