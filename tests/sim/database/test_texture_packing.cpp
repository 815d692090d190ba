#include "sim/database/texture_packing.hpp"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <stdexcept>

#include "sim/database/packed_scene.hpp"
#include "sim/scene/placement.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

std::string scene_of(const std::string& texture, const std::string& object) {
  return "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
         "surfaces: {red: {diffuse: [0.5, 0, 0.2], texture: " +
         texture + "}, plain: {diffuse: 1}}\nobject: " + object + "\n";
}

Scene read(const std::string& text) { return load_text(text).scene; }

constexpr const char* k_two =
    "{union: [{sphere: {radius: 2}, place: {translate: [5, 0, 0]}}, "
    "{sphere: {radius: 1}, surface: plain}, {box: {size: 1}, place: {translate: [0, 3, 0]}}], "
    "surface: red, place: {translate: [0, 0, 7]}}";

Vector3 in_pattern(const firmware::Texture<double>& texture, const Vector3& local) {
  return texture.from_leaf * glm::dvec4(local, 1);
}

firmware::Texture<double> texture_of(const PackedTextures& packed, const ObjectTree& tree,
                                     const Vector3& origin) {
  for (std::size_t i = 0; i < tree.leaves.size(); ++i) {
    if (glm::length(tree.leaves[i].to_scene[3] - origin) < 1e-9) {
      return packed.textures.at(packed.of_leaves.at(i));
    }
  }
  throw std::out_of_range("no such leaf");
}

TEST_CASE("A pattern lies in the frame of the object with the surface, or in each primitive's") {
  for (const bool is_own : {false, true}) {
    const Scene scene = read(scene_of(
        std::string("{pattern: bands, size: 0.5, frame: ") + (is_own ? "primitive}" : "object}"),
        k_two));
    const ObjectTree tree = object_tree_of(scene);
    const PackedTextures packed = packed_textures(scene, tree);
    CHECK(packed.textures.size() == 2);
    const auto ball = texture_of(packed, tree, {5, 0, 7});
    // The local frame of the ball is the unit sphere: x = 1 is 2 units from its centre.
    const double expected = ((is_own ? 0 : 5) + 2) / 0.5;
    CHECK(in_pattern(ball, {1, 0, 0}).x == Approx(expected));
    CHECK(in_pattern(ball, {0, 0, 1}).z == Approx(4));
    const auto block = texture_of(packed, tree, {0, 3, 7});
    CHECK(in_pattern(block, {0, 0, 0}).y == Approx(is_own ? 0 : 6));
  }
}

TEST_CASE("The place of a pattern moves it in its frame") {
  const Scene scene = read(scene_of("{pattern: bands, size: 0.5, place: {translate: [1, 0, 0]}}",
                                    "{sphere: {radius: 1}, surface: red}"));
  const PackedTextures packed = packed_textures(scene, object_tree_of(scene));
  CHECK(in_pattern(packed.textures.at(0), {1, 0, 0}).x == Approx(0).margin(1e-12));
}

TEST_CASE("The factors of a pattern give its two colours back") {
  const Scene scene = read(scene_of("{pattern: checker, color: [0.25, 0.5, 0.2]}",
                                    "{sphere: {radius: 1}, surface: red}"));
  const Color whole = packed_diffuse(scene.surfaces[0]);
  const firmware::Texture<double> texture =
      packed_textures(scene, object_tree_of(scene)).textures.at(0);
  CHECK(whole * Color(texture.colors[0]) == Color(0.5, 0, 0.2));
  CHECK(whole * Color(texture.colors[1]) == Color(0.25, 0.5, 0.2));
}

TEST_CASE("A picture is packed once, however many primitives have it") {
  const Scene scene =
      read(scene_of("{picture: {columns: 2, rows: 1, texels: 0102030a0b0c}, repeat_u: 3}", k_two));
  const ObjectTree tree = object_tree_of(scene);
  const PackedTextures packed = packed_textures(scene, tree);
  CHECK(packed.textures.size() == 1);
  CHECK(packed.texels == std::vector<std::uint8_t>{1, 2, 3, 10, 11, 12});
  CHECK(packed.textures[0].columns_per_turn == 6);
  CHECK(packed.textures[0].rows_per_turn == 1);
  int plain = 0;
  for (const std::uint16_t number : packed.of_leaves) {
    plain += number == firmware::k_no_texture ? 1 : 0;
  }
  CHECK(plain == 1);
}

TEST_CASE("A picture on a primitive without parameters is refused") {
  const Scene scene = read(scene_of("{picture: {columns: 1, rows: 1, texels: 010203}}",
                                    "{half_space: {}, surface: red}"));
  CHECK_THROWS_WITH(packed_textures(scene, object_tree_of(scene)),
                    Catch::Matchers::ContainsSubstring("half_space") &&
                        Catch::Matchers::ContainsSubstring("pattern"));
}

TEST_CASE("Textures take room on a board where a scene has them, and nowhere else") {
  const auto packed_of = [](const std::string& surface) {
    return packed_scene<float>(
        read("view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
             "surfaces: {red: " +
             surface + "}\nobject: {sphere: {radius: 1}, surface: red}\n"),
        {8, 8});
  };
  const PackedScene<float> plain = packed_of("{diffuse: 0.5}");
  CHECK_FALSE(plain.header.needs.textured);
  CHECK(plain.leaf_textures.empty());
  CHECK(plain.surface_ambients.empty());
  CHECK(plain.light_shapes.empty());
  const PackedScene<float> bands = packed_of("{diffuse: 0.5, texture: {pattern: bands}}");
  CHECK(bands.header.needs.textured);
  CHECK(bands.leaf_textures.size() == 1);
  CHECK(bands.header.texture_count == 1);
  CHECK(bands.texels.empty());
  const PackedScene<float> glowing = packed_of("{diffuse: 0.5, ambient: 2}");
  CHECK(glowing.header.needs.surface_ambient);
  CHECK(glowing.header.needs.ambient);
  CHECK(glowing.surface_ambients.at(0).x == 2);
}

}  // namespace
}  // namespace maquette::sim
