#pragma once

#include <cstdint>
#include <vector>

#include "firmware/database.hpp"
#include "sim/database/object_tree.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// The row of the firmware's table that a texture is of.
[[nodiscard]] firmware::TextureKind kind_of(const Texture& texture);

/// The reflectance that a textured surface is packed with, by which its texture's factors are
/// multiplied: the larger of a pattern's two colours, what tints a picture.
[[nodiscard]] Color packed_diffuse(const Surface& surface);

/// The textures of a scene as the boards get them.
struct PackedTextures {
  std::vector<std::uint16_t> of_leaves;  ///< one for each leaf, or none when the scene has none
  std::vector<firmware::Texture<double>> textures;
  std::vector<std::uint8_t> texels;
};

/// Throws DescriptionError for a picture on a primitive whose surface has no parameters, and for
/// more textures than a board can number.
[[nodiscard]] PackedTextures packed_textures(const Scene& scene, const ObjectTree& tree);

}  // namespace maquette::sim
