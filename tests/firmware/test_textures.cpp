#include "firmware/textures.hpp"

#include <cmath>
#include <memory>
#include <vector>

#include "tests/catch.hpp"
#include "tests/firmware/test_frame.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Random;

const Color<double> k_first(1, 0.9, 0.8);
const Color<double> k_second(0.1, 0.2, 0.3);

/// A frame of one unit sphere with a texture.
struct Textured {
  explicit Textured(Texture<double> given, const trial::Placement& to_scene = trial::unmoved())
      : texture(given) {
    model.surfaces = {trial::matt_surface(), trial::matt_surface()};
    const NodeIndex root = model.add(kind_of<sphere::Kind>, to_scene);
    built = std::make_unique<BuiltFrame<double>>(model, root);
    Database<double>& database = built->frame.database;
    database.leaf_textures = &number;
    database.textures = &texture;
    database.texels = texels.data();
  }

  Color<double> at(const Vector<double>& position, SurfaceIndex surface = 0) {
    SurfacePoint<double> point{};
    point.position = position;
    point.surface = surface;
    return tint_of(built->frame, point);
  }

  Model model;
  Texture<double> texture;
  std::uint16_t number = 0;
  std::vector<std::uint8_t> texels;
  std::unique_ptr<BuiltFrame<double>> built;
};

template <class Kind>
Texture<double> pattern(const trial::Placement& from_leaf = trial::unmoved()) {
  Texture<double> texture{};
  texture.kind = texture_kind_of<Kind>;
  texture.from_leaf = from_leaf;
  texture.colors[0] = k_first;
  texture.colors[1] = k_second;
  return texture;
}

const Color<double>& of_parity(long cell) { return cell % 2 == 0 ? k_first : k_second; }

long cell(double value) { return std::lround(std::floor(value + k_cell_offset)); }

TEST_CASE("Patterns change colour from cell to cell") {
  Random random(1201);
  Textured checkered(pattern<checker::Kind>());
  Textured banded(pattern<bands::Kind>());
  Textured ringed(pattern<rings::Kind>());
  for (int i = 0; i < 5000; ++i) {
    const Vector<double> p = random.in_cube(40);
    REQUIRE(checkered.at(p) == of_parity(cell(p.x) + cell(p.y) + cell(p.z)));
    REQUIRE(banded.at(p) == of_parity(cell(p.x)));
    REQUIRE(ringed.at(p) == of_parity(cell(std::hypot(p.x, p.y))));
  }
}

TEST_CASE("A face laid on a border of cells is of one colour, however it was rounded") {
  Textured checkered(pattern<checker::Kind>());
  for (const double rounding : {-1e-5, 0.0, 1e-5}) {
    for (int z = -3; z <= 3; ++z) {
      CHECK(checkered.at({0.5, 0.5, z + rounding}) == of_parity(z));
    }
  }
}

TEST_CASE("A pattern turns, moves and grows with the frame of its leaf") {
  Random random(1202);
  for (int i = 0; i < 200; ++i) {
    const trial::Placement moved =
        random.placement(random.in_cube(5), random.magnitude(0.1, 10), 2);
    Textured still(pattern<checker::Kind>());
    Textured carried(pattern<checker::Kind>(), moved);
    const Vector<double> local = random.in_cube(5);
    CHECK(carried.at(transform_point(moved, local)) == still.at(local));
  }
}

TEST_CASE("A surface that is not the leaf's own shows no texture") {
  Textured checkered(pattern<checker::Kind>());
  CHECK(checkered.at({1.5, 0.5, 0.5}, 0) == k_second);
  CHECK(checkered.at({1.5, 0.5, 0.5}, 1) == Color<double>(1, 1, 1));
  checkered.number = k_no_texture;
  CHECK(checkered.at({1.5, 0.5, 0.5}, 0) == Color<double>(1, 1, 1));
}

TEST_CASE("Far from the origin a pattern ends, and no number overflows") {
  Textured checkered(pattern<checker::Kind>());
  CHECK(checkered.at({1e30, 0.5, 0.5}) == checkered.at({1e20, 0.5, 0.5}));
  CHECK(checkered.at({-1e30, 0.5, 0.5}) == checkered.at({-1e20, 0.5, 0.5}));
}

TEST_CASE("Every texel of a picture is seen at its place, as often as it repeats") {
  constexpr int k_columns = 5;
  constexpr int k_rows = 4;
  for (const int repeat : {1, 3}) {
    Texture<double> texture{};
    texture.kind = texture_kind_of<picture::Kind>;
    texture.colors[0] = {0.5, 1, 1};
    texture.columns = k_columns;
    texture.rows = k_rows;
    texture.columns_per_turn = k_columns * repeat;
    texture.rows_per_turn = k_rows;
    texture.first_texel = 2;
    Textured ball(texture);
    ball.texels.resize(2);
    for (int texel = 0; texel < k_columns * k_rows; ++texel) {
      ball.texels.insert(ball.texels.end(), {static_cast<std::uint8_t>(texel * 10), 255, 0});
    }
    ball.built->frame.database.texels = ball.texels.data();
    for (int row = 0; row < k_rows; ++row) {
      for (int column = 0; column < k_columns * repeat; ++column) {
        const double longitude = 2 * elementary::k_pi * (column + 0.5) / (k_columns * repeat);
        const double latitude = elementary::k_pi * ((row + 0.5) / k_rows - 0.5);
        const Vector<double> p(std::cos(latitude) * std::cos(longitude),
                               std::cos(latitude) * std::sin(longitude), std::sin(latitude));
        const int texel = (k_rows - 1 - row) * k_columns + column % k_columns;
        CHECK(ball.at(p).x == Approx(0.5 * texel * 10 / 255));
        CHECK(ball.at(p).y == 1);
        CHECK(ball.at(p).z == 0);
      }
    }
  }
}

TEST_CASE("A textured wall shows its cells in a picture") {
  Model model;
  model.surfaces = {trial::matt_surface({1, 1, 1})};
  model.ambient = {1, 1, 1};
  model.needs.textured = true;
  const NodeIndex root = model.add(
      kind_of<half_space::Kind>, concatenate(trial::moved({0, 0, 10}), trial::scaled({1, 1, -1})));
  BuiltFrame<double> built(model, root);
  const std::uint16_t number = 0;
  Texture<double> texture = pattern<bands::Kind>();
  built.frame.database.leaf_textures = &number;
  built.frame.database.textures = &texture;
  int seen[2] = {0, 0};
  for (std::int16_t column = 0; column < 64; ++column) {
    const std::uint32_t rgb = built.pixel(column, 24).rgb;
    const double x = 10 * (column - 31.5) / 48;
    const Color<double>& expected = of_parity(cell(x));
    if (std::abs(x + k_cell_offset - std::round(x)) > 0.05) {
      CHECK(rgb == rgb_of(expected));
      ++seen[&expected == &k_second ? 1 : 0];
    }
  }
  CHECK(seen[0] > 10);
  CHECK(seen[1] > 10);
}

}  // namespace
}  // namespace maquette::firmware
