#include "firmware/arithmetic/maquette_ffp/format.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/arithmetic/maquette_ffp/operands.hpp"

namespace maquette::tests {
namespace {

using namespace firmware::maquette_ffp;

TEST_CASE("A number of the format is its mantissa times a power of two") {
  CHECK(from_ffp(0x80000041) == 1.0F);
  CHECK(from_ffp(0xc00000c2) == -3.0F);
  CHECK(from_ffp(0x80000000) == 0x1p-65F);
  CHECK(from_ffp(k_largest) == 0x1.fffffep62F);
  Bits bits(1);
  for (int i = 0; i < 1'000'000; ++i) {
    const std::uint32_t number = any_number(bits);
    const double magnitude = std::ldexp(static_cast<double>(number >> 8U) / 0x1p24,
                                        static_cast<int>(number & 0x7fU) - 64);
    REQUIRE(static_cast<double>(from_ffp(number)) ==
            ((number & k_sign) != 0 ? -magnitude : magnitude));
  }
}

TEST_CASE("Floats in range go through the format and back") {
  Bits bits(2);
  for (int i = 0; i < 1'000'000; ++i) {
    const std::uint32_t number = any_number(bits);
    REQUIRE(to_ffp(from_ffp(number)) == number);
  }
}

TEST_CASE("Floats out of range are zero or the largest number") {
  CHECK(to_ffp(0.0F) == 0);
  CHECK(to_ffp(-0.0F) == 0);
  CHECK(to_ffp(0x1.fffffep-66F) == 0);
  CHECK(to_ffp(-0x1.fffffep-66F) == 0);
  CHECK(to_ffp(1e-45F) == 0);
  CHECK(to_ffp(0x1p-65F) == 0x80000000);
  CHECK(to_ffp(0x1p63F) == k_largest);
  CHECK(to_ffp(-0x1p63F) == (k_largest | k_sign));
  CHECK(to_ffp(HUGE_VALF) == k_largest);
  CHECK(to_ffp(-HUGE_VALF) == (k_largest | k_sign));
}

}  // namespace
}  // namespace maquette::tests
