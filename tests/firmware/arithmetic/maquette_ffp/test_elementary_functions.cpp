#include <cmath>

#include "models/board/maquette_ffp/package_number.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/arithmetic/maquette_ffp/operands.hpp"

namespace maquette::tests {
namespace {

using models::PackageNumber;
using models::value_of;

constexpr int k_cases = 50'000;
/// Where e^x lies between 2^-62 and 2^62.
constexpr float k_exponential_range = 42.97F;

float uniform(Bits& bits, float low, float high) {
  return low + (high - low) * static_cast<float>(bits.next() >> 40U) * 0x1p-24F;
}

TEST_CASE("Exponentials computed with the package have a float's bits") {
  Bits bits(1);
  for (int i = 0; i < k_cases; ++i) {
    const float x = uniform(bits, -k_exponential_range, k_exponential_range);
    REQUIRE(value_of(firmware::exponential(PackageNumber(x))) == firmware::exponential(x));
  }
}

TEST_CASE("Exponentials beyond the package's range are zero or the largest number") {
  const float largest =
      firmware::maquette_ffp::from_ffp(firmware::maquette_ffp::k_largest & ~0x80U);
  for (const float x : {k_exponential_range + 0.1F, 44.0F, 50.0F, 1000.0F}) {
    CHECK(value_of(firmware::exponential(PackageNumber(x))) == largest);
    CHECK(value_of(firmware::exponential(PackageNumber(-x))) == 0);
  }
}

TEST_CASE("Logarithms computed with the package have a float's bits") {
  Bits bits(2);
  for (int i = 0; i < k_cases; ++i) {
    const std::uint32_t number = any_number(bits) & ~firmware::maquette_ffp::k_sign;
    if (number == 0) continue;
    const PackageNumber x = PackageNumber::of_bits(number);
    REQUIRE(value_of(firmware::logarithm(x)) == firmware::logarithm(value_of(x)));
  }
}

TEST_CASE("Powers computed with the package have a float's bits where they are in range") {
  Bits bits(3);
  for (int i = 0; i < k_cases; ++i) {
    const float base = uniform(bits, 0, 2);
    const float exponent = uniform(bits, 0, 20);
    const float expected = firmware::power(base, exponent);
    const float result = value_of(firmware::power(PackageNumber(base), PackageNumber(exponent)));
    if (expected < 0x1p-60F) {
      REQUIRE(result <= 0x1p-60F);
    } else {
      REQUIRE(result == expected);
    }
  }
}

TEST_CASE("Arc cosines computed with the package have a float's bits") {
  Bits bits(4);
  for (int i = 0; i < k_cases; ++i) {
    const float cosine = uniform(bits, 0, 1);
    REQUIRE(value_of(firmware::arc_cosine(PackageNumber(cosine))) == firmware::arc_cosine(cosine));
  }
}

}  // namespace
}  // namespace maquette::tests
