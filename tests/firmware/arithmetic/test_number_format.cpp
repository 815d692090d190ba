#include "firmware/arithmetic/number_format.hpp"

#include <cmath>
#include <random>

#include "tests/catch.hpp"

namespace maquette::firmware {
namespace {

/// Floats of every kind, those of all bits among them.
template <class Check>
void for_any_float(Check check) {
  for (const float value : {0.0F, 1.0F, 1e-45F, 1e-20F, 0x1p-65F, 0x1p63F, 3e38F, HUGE_VALF, NAN}) {
    check(value);
    check(-value);
  }
  std::mt19937 random(1);
  for (int i = 0; i < 1'000'000; ++i) {
    const auto bits = static_cast<std::uint32_t>(random());
    check(__builtin_bit_cast(float, bits));
  }
}

TEST_CASE("a number in IEEE single precision is the float, and changes its sign as that does") {
  for_any_float([](float value) {
    const std::uint32_t bits = IeeeSingleFormat::bits_of(value);
    REQUIRE(bits == __builtin_bit_cast(std::uint32_t, value));
    REQUIRE(IeeeSingleFormat::bits_of(IeeeSingleFormat::value_of(bits)) == bits);
    REQUIRE(IeeeSingleFormat::negative(bits) == IeeeSingleFormat::bits_of(-value));
    REQUIRE(IeeeSingleFormat::magnitude(bits) == IeeeSingleFormat::bits_of(std::fabs(value)));
  });
}

TEST_CASE(
    "a number in the FFP format changes its sign as a float does, but for zero, which has none") {
  for_any_float([](float value) {
    const std::uint32_t bits = FfpFormat::bits_of(value);
    const float held = FfpFormat::value_of(bits);
    REQUIRE(FfpFormat::negative(bits) == FfpFormat::bits_of(-held));
    REQUIRE(FfpFormat::magnitude(bits) == FfpFormat::bits_of(std::fabs(held)));
  });
  CHECK(FfpFormat::negative(FfpFormat::bits_of(0)) == 0);
}

TEST_CASE("only zeros have no magnitude") {
  for_any_float([](float value) {
    const std::uint32_t bits = IeeeSingleFormat::bits_of(value);
    REQUIRE((IeeeSingleFormat::magnitude(bits) == 0) == (value == 0));
    const std::uint32_t ffp = FfpFormat::bits_of(value);
    REQUIRE((FfpFormat::magnitude(ffp) == 0) == (FfpFormat::value_of(ffp) == 0));
  });
}

TEST_CASE("formats have bits of their own") {
  CHECK(bits_in(NumberFormat::ffp, 1) == 0x80000041);
  CHECK(bits_in(NumberFormat::ffp, -0.5F) == 0x800000C0);
  CHECK(bits_in(NumberFormat::ffp, -0.0F) == 0);
  CHECK(bits_in(NumberFormat::ieee_single, 1) == 0x3F800000);
  CHECK(bits_in(NumberFormat::ieee_single, -0.0F) == 0x80000000);
}

}  // namespace
}  // namespace maquette::firmware
