#include "sim/page/picture_difference.hpp"

#include "tests/catch.hpp"

using maquette::models::Picture;
using maquette::sim::difference_picture;

TEST_CASE("Equal pixels are black, the largest difference is full, the least can be seen") {
  const Picture first{3, 1, {0x102030, 0x000000, 0xFFFFFF}};
  const Picture second{3, 1, {0x102030, 0x640001, 0xFFFFFF}};
  const Picture difference = difference_picture(first, second);
  CHECK(difference.width == 3);
  CHECK(difference.height == 1);
  CHECK(difference.pixels == std::vector<std::uint32_t>{0, 0xFF0041, 0});
  CHECK(difference_picture(second, first).pixels == difference.pixels);
  CHECK(difference_picture(first, first).pixels == std::vector<std::uint32_t>(3, 0));
}
