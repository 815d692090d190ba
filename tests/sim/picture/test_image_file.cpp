#include <random>
#include <set>
#include <stdexcept>

#include "sim/picture/image_file.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using maquette::models::DepthMap;
using maquette::models::Picture;
using maquette::sim::decode_depths;
using maquette::sim::decode_png;
using maquette::sim::DescriptionError;
using maquette::sim::encode_depths;
using maquette::sim::encode_png;

namespace {

Picture random_picture(std::mt19937& random, int width, int height) {
  Picture picture{width, height, {}};
  const auto smoothness = 1 + random() % 8;
  std::uint_fast32_t value = 0;
  for (int i = 0; i < width * height; ++i) {
    value += random() % smoothness == 0 ? random() : 0;
    picture.pixels.push_back(static_cast<std::uint32_t>(value & 0xffffff));
  }
  return picture;
}

std::set<std::string> chunk_kinds(const std::string& png) {
  std::set<std::string> kinds;
  for (std::size_t at = 8; at < png.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      length = length * 256 + static_cast<std::uint8_t>(png[at + i]);
    }
    kinds.insert(png.substr(at + 4, 4));
    at += 12 + length;
  }
  return kinds;
}

}  // namespace

TEST_CASE("pictures of any size come back as they were, and give the same bytes twice") {
  std::mt19937 random(2);
  for (int i = 0; i < 60; ++i) {
    const auto width = static_cast<int>(1 + random() % 70);
    const auto height = static_cast<int>(1 + random() % 70);
    const Picture picture = random_picture(random, width, height);
    const std::string png = encode_png(picture);
    const Picture again = decode_png(png, "picture");
    REQUIRE(again.width == width);
    REQUIRE(again.height == height);
    REQUIRE(again.pixels == picture.pixels);
    REQUIRE(encode_png(picture) == png);
  }
}

TEST_CASE("depths of any size come back whole, and are no picture") {
  std::mt19937 random(5);
  for (int i = 0; i < 40; ++i) {
    DepthMap depths{static_cast<int>(1 + random() % 70), static_cast<int>(1 + random() % 70), {}};
    for (int pixel = 0; pixel < depths.width * depths.height; ++pixel) {
      depths.values.push_back(static_cast<std::uint16_t>(random()));
    }
    const std::string png = encode_depths(depths);
    const DepthMap again = decode_depths(png, "depths");
    REQUIRE(again.width == depths.width);
    REQUIRE(again.height == depths.height);
    REQUIRE(again.values == depths.values);
    REQUIRE(encode_depths(depths) == png);
    CHECK_THROWS_AS(decode_png(png, "depths"), DescriptionError);
  }
  CHECK_THROWS_AS(decode_depths(encode_png({1, 1, {0}}), "picture"), DescriptionError);
  CHECK_THROWS_AS(encode_depths({2, 1, {0}}), std::invalid_argument);
  CHECK_THROWS_AS(encode_depths({0, 0, {}}), std::invalid_argument);
}

TEST_CASE("a picture file holds neither time nor gamma") {
  std::mt19937 random(3);
  const auto kinds = chunk_kinds(encode_png(random_picture(random, 20, 10)));
  CHECK(kinds.count("IDAT") == 1);
  for (const char* kind : {"tIME", "gAMA", "sRGB", "cHRM", "iCCP", "tEXt", "zTXt", "iTXt"}) {
    INFO(kind);
    CHECK(kinds.count(kind) == 0);
  }
}

TEST_CASE("a picture of the wrong size is refused") {
  CHECK_THROWS_AS(encode_png({0, 0, {}}), std::invalid_argument);
  CHECK_THROWS_AS(encode_png({2, 2, std::vector<std::uint32_t>(3)}), std::invalid_argument);
  CHECK_THROWS_AS(encode_png({-2, -2, std::vector<std::uint32_t>(4)}), std::invalid_argument);
}

TEST_CASE("a damaged picture is refused with its name") {
  std::mt19937 random(4);
  const std::string png = encode_png(random_picture(random, 64, 64));
  CHECK_THROWS_WITH(decode_png("", "a/frame.png"),
                    Catch::Matchers::ContainsSubstring("a/frame.png"));
  CHECK_THROWS_AS(decode_png("not a picture at all", "x"), DescriptionError);
  for (const std::size_t length : {8U, 20U, 33U, 60U, 200U}) {
    INFO(length);
    CHECK_THROWS_AS(decode_png(png.substr(0, length), "x"), DescriptionError);
  }
  std::string changed = png;
  changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 0x55);
  CHECK_THROWS_AS(decode_png(changed, "x"), DescriptionError);
}
