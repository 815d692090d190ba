#include "sim/scene/placement.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>

#include "sim/scene/rotation.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

Placement placement(const std::string& text) { return read_placement(parse_yaml(text, "text")); }

Vector3 moved(const Placement& place, const Vector3& point) {
  return place[0] * point.x + place[1] * point.y + place[2] * point.z + place[3];
}

double between(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
}

}  // namespace

TEST_CASE("steps are applied in their order") {
  const Vector3 point{1, 0, 0};
  const std::string turn = "{rotate: {axis: [0, 0, 1], angle: 90 deg}}";
  const std::string move = "{translate: [10, 0, 0]}";
  const std::string scale = "{scale: [2, 3, 4]}";
  CHECK(moved(placement("[" + turn + ", " + move + "]"), point) == Vector3{10, 1, 0});
  CHECK(moved(placement("[" + move + ", " + turn + "]"), point) == Vector3{0, 11, 0});
  CHECK(moved(placement("[" + move + ", " + scale + "]"), point) == Vector3{22, 0, 0});
  CHECK(moved(placement("[" + turn + ", " + scale + "]"), point) == Vector3{0, 3, 0});
  CHECK(placement("[]") == Placement{1.0});
}

TEST_CASE("a matrix is written row by row") {
  const Placement place = placement("{matrix: [1, 0, 0, 4, 0, 0, -1, 5, 0, 1, 0, 6]}");
  CHECK(moved(place, {1, 2, 3}) == Vector3{5, 2, 8});
}

TEST_CASE("a quarter turn is exact around each axis, and right-handed") {
  CHECK(rotation({0, 0, 7}, 90) * Vector3{1, 0, 0} == Vector3{0, 1, 0});
  CHECK(rotation({1e-300, 0, 0}, 90) * Vector3{0, 1, 0} == Vector3{0, 0, 1});
  CHECK(rotation({0, 1e300, 0}, 90) * Vector3{0, 0, 1} == Vector3{1, 0, 0});
  for (int quarters = -20; quarters <= 20; ++quarters) {
    const auto [sine, cosine] = sine_cosine_deg(quarters * 90.0);
    const int phase = ((quarters % 4) + 4) % 4;
    CHECK(sine == (phase == 1 ? 1 : phase == 3 ? -1 : 0));
    CHECK(cosine == (phase == 0 ? 1 : phase == 2 ? -1 : 0));
  }
}

TEST_CASE("sine and cosine agree with the C library's at every angle") {
  std::mt19937 random{3};
  for (int i = 0; i < 20'000; ++i) {
    const double degrees = between(random, -1000, 1000);
    const auto [sine, cosine] = sine_cosine_deg(degrees);
    const long double radians = std::remainder(degrees, 360.0) * 0.017453292519943295769236907685L;
    INFO(degrees);
    REQUIRE(std::fabs(static_cast<double>(sine - std::sin(radians))) < 4e-16);
    REQUIRE(std::fabs(static_cast<double>(cosine - std::cos(radians))) < 4e-16);
  }
}

TEST_CASE("a rotation keeps lengths, its axis and its sense") {
  std::mt19937 random{4};
  for (int i = 0; i < 2000; ++i) {
    const Vector3 axis{between(random, -2, 2), between(random, -2, 2), between(random, -2, 2)};
    const glm::dmat3 turn = rotation(axis, between(random, -720, 720));
    REQUIRE(glm::length(turn * axis - axis) < 1e-14 * (1 + glm::length(axis)));
    REQUIRE(std::fabs(glm::determinant(turn) - 1) < 1e-14);
    for (int column = 0; column < 3; ++column) {
      REQUIRE(std::fabs(glm::length(turn[column]) - 1) < 1e-14);
    }
  }
}

TEST_CASE("a placement is written so that it reads back exactly") {
  std::mt19937 random{5};
  for (int i = 0; i < 2000; ++i) {
    Placement place{1.0};
    for (int column = 0; column < 4; ++column) {
      for (int row = 0; row < 3; ++row) {
        place[column][row] = between(random, -1, 1) * std::pow(10.0, between(random, -5, 5));
      }
    }
    REQUIRE((is_singular(place) || placement(write_yaml(write_placement(place))) == place));
  }
}

TEST_CASE("concatenation is applying one after the other, at any size") {
  std::mt19937 random{6};
  for (const double size : {1e-6, 1.0, 1e6}) {
    const Placement inner = placement("[{rotate: {axis: [1, 2, 3], angle: 40 deg}}, {scale: 3}]");
    Placement outer = placement("[{rotate: {axis: [3, 2, 1], angle: 70 deg}}, {scale: [1, 2, 3]}]");
    outer[3] = {size, -size, 2 * size};
    const Placement both = concatenated(outer, inner);
    for (int i = 0; i < 100; ++i) {
      const Vector3 point{between(random, -size, size), between(random, -size, size), size};
      REQUIRE(glm::length(moved(both, point) - moved(outer, moved(inner, point))) < 1e-13 * size);
    }
  }
}

TEST_CASE("flat placements are recognised at any size") {
  for (const double size : {1e-9, 1.0, 1e9}) {
    const Placement whole{{size, 0, 0}, {0, size, 0}, {0, 0, size}, {0, 0, 0}};
    CHECK_FALSE(is_singular(whole));
    const Placement flat{{size, 0, 0}, {0, size, 0}, {size, size, 0}, {0, 0, 0}};
    CHECK(is_singular(flat));
    const Placement nearly{{size, 0, 0}, {0, size, 0}, {size, size, size * 1e-13}, {0, 0, 0}};
    CHECK(is_singular(nearly));
  }
}

}  // namespace maquette::sim
