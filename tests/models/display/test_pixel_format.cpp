#include "models/display/pixel_format.hpp"

#include <cstdlib>
#include <random>
#include <stdexcept>

#include "tests/catch.hpp"

using maquette::models::FrameMemoryParameters;
using maquette::models::PixelFormat;

namespace {

FrameMemoryParameters planes(int red, int green, int blue, int depth) {
  FrameMemoryParameters parameters;
  parameters.red_bits = red;
  parameters.green_bits = green;
  parameters.blue_bits = blue;
  parameters.depth_bits = depth;
  return parameters;
}

int component(std::uint32_t rgb, int shift) {
  return static_cast<int>(rgb >> static_cast<unsigned>(shift) & 0xFFU);
}

// The farthest that the colour shown may be from the one written.
int worst_error(int bits) { return (0xFF >> bits) + 1; }

}  // namespace

TEST_CASE("what planes keep of a pixel shows as the nearest colour that they have, and its depth") {
  std::mt19937 random(5);
  for (int i = 0; i < 20'000; ++i) {
    const auto number = [&random](int first, int last) {
      return first + static_cast<int>(random() % static_cast<unsigned>(last - first + 1));
    };
    const bool has_depth = random() % 2 == 0;
    const int most = has_depth ? 5 : 8;
    const FrameMemoryParameters memory =
        planes(number(1, most), number(1, most), number(1, most), has_depth ? number(1, 16) : 0);
    const PixelFormat format(memory);
    const auto rgb = static_cast<std::uint32_t>(random()) & 0xFFFFFFU;
    const auto depth = static_cast<std::uint16_t>(random());
    const std::uint32_t kept = format.written(rgb, depth) & format.kept();
    const std::uint32_t shown = format.colour(kept);
    const int bits[3] = {memory.red_bits, memory.green_bits, memory.blue_bits};
    for (int k = 0; k < 3; ++k) {
      REQUIRE(std::abs(component(shown, 16 - 8 * k) - component(rgb, 16 - 8 * k)) <=
              worst_error(bits[k]));
    }
    if (memory.depth_bits > 0) {
      REQUIRE(depth - format.depth(kept) >= 0);
      REQUIRE(depth - format.depth(kept) < 1 << (16 - memory.depth_bits));
    } else {
      REQUIRE(format.depth(kept) == 0);
    }
  }
}

TEST_CASE("black and white stay so for any planes, and 24 planes keep every colour") {
  for (int bits = 1; bits <= 8; ++bits) {
    const PixelFormat format(planes(bits, bits, bits, bits <= 5 ? 16 : 0));
    CHECK(format.colour(format.written(0, 0) & format.kept()) == 0);
    CHECK(format.colour(format.written(0xFFFFFF, 0) & format.kept()) == 0xFFFFFF);
  }
  const PixelFormat full(planes(8, 8, 8, 0));
  for (std::uint32_t code = 0; code < 256; ++code) {
    const std::uint32_t rgb = code << 16U | (255 - code) << 8U | (code ^ 0x55U);
    REQUIRE(full.colour(full.written(rgb, 7) & full.kept()) == rgb);
  }
  CHECK(full.kept() == 0xFFFFFF00);
}

TEST_CASE("the display of the paper's section VI keeps 16 bits of colour beside 16 of depth") {
  const PixelFormat display(planes(4, 8, 4, 16));
  CHECK(display.kept() == 0xFFFFFFFF);
  CHECK(display.written(0xA1B2C3, 0x1234) == 0xAB2C1234);
  CHECK(display.depth(0xAB2C1234) == 0x1234);
}

TEST_CASE("planes that no memory has are refused") {
  CHECK_THROWS_AS(PixelFormat(planes(0, 8, 8, 0)), std::invalid_argument);
  CHECK_THROWS_AS(PixelFormat(planes(8, 9, 8, 0)), std::invalid_argument);
  CHECK_THROWS_AS(PixelFormat(planes(4, 8, 4, 17)), std::invalid_argument);
  CHECK_THROWS_AS(PixelFormat(planes(4, 8, 4, -1)), std::invalid_argument);
  CHECK_THROWS_AS(PixelFormat(planes(4, 8, 5, 16)), std::invalid_argument);
}
