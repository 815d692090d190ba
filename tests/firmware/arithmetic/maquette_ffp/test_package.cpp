#include "firmware/arithmetic/maquette_ffp/package.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "models/board/maquette_ffp/package_processor.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/arithmetic/maquette_ffp/operands.hpp"

namespace maquette::tests {
namespace {

using namespace firmware::maquette_ffp;
using models::PackageCall;
using models::PackageProcessor;

constexpr int k_cases = 4'000'000;

/// The package's format rounds an operation's exact result as float does, but for its range.
template <class Operation>
void check_operation(std::uint32_t entry, std::uint32_t seed, const Operation& operation) {
  PackageProcessor processor;
  Bits bits(seed);
  long wrong = 0;
  for (int i = 0; i < k_cases; ++i) {
    const Operands operands = any_operands(bits);
    const std::uint32_t result = processor.call(entry, operands.d7, operands.d6).result;
    const std::uint32_t expected = operation(from_ffp(operands.d7), from_ffp(operands.d6));
    if (result != expected && wrong++ < 10) {
      UNSCOPED_INFO(std::hex << operands.d7 << " and " << operands.d6 << " give " << result
                             << " instead of " << expected);
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("Sums have a float's bits") {
  check_operation(k_add_entry, 1, [](float a, float b) { return to_ffp(a + b); });
}

TEST_CASE("Differences have a float's bits") {
  check_operation(k_subtract_entry, 2, [](float a, float b) { return to_ffp(a - b); });
}

TEST_CASE("Products have a float's bits") {
  check_operation(k_multiply_entry, 3, [](float a, float b) { return to_ffp(a * b); });
}

TEST_CASE("Quotients have a float's bits, and by zero they are the largest number") {
  check_operation(k_divide_entry, 4, [](float a, float b) {
    if (a == 0) return 0U;
    if (b == 0) return k_largest | (a < 0 ? k_sign : 0U);
    return to_ffp(a / b);
  });
}

TEST_CASE("Square roots have a float's bits, and of negative numbers they are zero") {
  check_operation(k_square_root_entry, 5,
                  [](float a, float) { return a < 0 ? 0U : to_ffp(std::sqrt(a)); });
}

TEST_CASE("Signs change as a float's, but for the sign of zero") {
  check_operation(k_negate_entry, 6, [](float a, float) { return to_ffp(-a); });
  check_operation(k_absolute_entry, 7, [](float a, float) { return to_ffp(std::fabs(a)); });
}

TEST_CASE("Numbers become integers by truncation, and the nearest integer out of range") {
  check_operation(k_to_integer_entry, 8, [](float a, float) {
    if (a >= 2147483648.0F) return 0x7fffffffU;
    if (a <= -2147483648.0F) return 0x80000000U;
    return static_cast<std::uint32_t>(static_cast<std::int32_t>(a));
  });
}

TEST_CASE("Integers become numbers with a float's bits") {
  PackageProcessor processor;
  Bits bits(9);
  for (int i = 0; i < k_cases; ++i) {
    const std::uint32_t integer = any_integer(bits);
    const auto expected = static_cast<float>(static_cast<std::int32_t>(integer));
    REQUIRE(processor.call(k_from_integer_entry, integer).result == to_ffp(expected));
  }
}

TEST_CASE("A comparison sets the codes of the signed conditions") {
  PackageProcessor processor;
  Bits bits(10);
  for (int i = 0; i < k_cases; ++i) {
    const Operands operands = any_operands(bits);
    const PackageCall call = processor.call(k_compare_entry, operands.d7, operands.d6);
    const float a = from_ffp(operands.d7);
    const float b = from_ffp(operands.d6);
    const bool less = call.conditions.negative() != call.conditions.overflow;
    REQUIRE(call.conditions.zero() == (a == b));
    REQUIRE((less && !call.conditions.zero()) == (a < b));
    REQUIRE((!less && !call.conditions.zero()) == (a > b));
    REQUIRE(call.result == operands.d7);
  }
}

TEST_CASE("A test sets the codes of a comparison with zero") {
  PackageProcessor processor;
  Bits bits(11);
  for (int i = 0; i < k_cases; ++i) {
    const std::uint32_t number = any_number(bits);
    const PackageCall call = processor.call(k_test_entry, number);
    REQUIRE(call.conditions.negative() == (from_ffp(number) < 0));
    REQUIRE(call.conditions.zero() == (number == 0));
    REQUIRE_FALSE(call.conditions.overflow);
    REQUIRE_FALSE(call.conditions.carry);
    REQUIRE(call.result == number);
  }
}

TEST_CASE("Routines change no registers but D3 to D5 and D7, and no memory but the stack") {
  constexpr std::array<std::uint32_t, 11> k_entries = {
      k_add_entry,     k_subtract_entry,     k_multiply_entry,   k_divide_entry,
      k_compare_entry, k_square_root_entry,  k_negate_entry,     k_absolute_entry,
      k_test_entry,    k_from_integer_entry, k_to_integer_entry,
  };
  Bits bits(12);
  for (const std::uint32_t entry : k_entries) {
    PackageProcessor processor;
    for (int i = 0; i < 200'000; ++i) {
      for (auto& each : processor.registers().general) {
        each = static_cast<std::uint32_t>(bits.next() >> 32U);
      }
      auto expected = processor.registers().general;
      const Operands operands = any_operands(bits);
      const PackageCall call = processor.call(entry, operands.d7, operands.d6);
      const auto& general = processor.registers().general;
      std::copy_n(general.begin() + 3, 3, expected.begin() + 3);
      expected[6] = operands.d6;
      expected[7] = call.result;
      expected[15] = general[15];
      REQUIRE(general == expected);
      REQUIRE(general[15] == 16);
      // A routine that calls itself, near the limits of the range, pushes an address of two words.
      REQUIRE((call.writes == 0 || call.writes == 2));
    }
  }
}

TEST_CASE("The parts are the package") {
  std::uint32_t bytes = 0;
  for (const PackagePart& part : k_package_parts) {
    CHECK(part.bytes % 2 == 0);
    bytes += part.bytes + part.bytes % 4;
  }
  CHECK(bytes == sizeof k_package);
}

}  // namespace
}  // namespace maquette::tests
