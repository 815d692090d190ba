#include "models/board/maquette_ffp/routine_cost.hpp"

#include <algorithm>

#include "firmware/arithmetic/maquette_ffp/package.hpp"
#include "models/board/maquette_ffp/package_processor.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/arithmetic/maquette_ffp/operands.hpp"

namespace maquette::tests {
namespace {

using namespace firmware::maquette_ffp;
using models::PackageCall;
using models::PackageProcessor;
using models::RoutineCost;

constexpr int k_cases = 3'000'000;

/// Each cost is what the MC68000 takes, operand by operand.
template <class Cost>
void check_cost(std::uint32_t entry, std::uint32_t seed, const Cost& cost) {
  PackageProcessor processor;
  Bits bits(seed);
  long wrong = 0;
  for (int i = 0; i < k_cases; ++i) {
    const Operands operands = any_operands(bits);
    const PackageCall call = processor.call(entry, operands.d7, operands.d6);
    const RoutineCost expected = cost(operands.d7, operands.d6);
    const bool same = expected.cycles == call.cycles && expected.reads == call.reads &&
                      expected.writes == call.writes;
    if (!same && wrong++ < 10) {
      UNSCOPED_INFO(std::hex << operands.d7 << " and " << operands.d6 << std::dec << " take "
                             << call.cycles << " (" << call.reads << "/" << call.writes
                             << ") and not " << expected.cycles << " (" << expected.reads << "/"
                             << expected.writes << ")");
    }
  }
  CHECK(wrong == 0);
}

TEST_CASE("The cost of an addition is exact") { check_cost(k_add_entry, 1, models::add_cost); }

TEST_CASE("The cost of a subtraction is exact") {
  check_cost(k_subtract_entry, 2, models::subtract_cost);
}

TEST_CASE("The cost of a multiplication is exact") {
  check_cost(k_multiply_entry, 3, models::multiply_cost);
}

TEST_CASE("The cost of a division is exact") { check_cost(k_divide_entry, 4, models::divide_cost); }

TEST_CASE("The cost of a square root is exact") {
  check_cost(k_square_root_entry, 5,
             [](std::uint32_t d7, std::uint32_t) { return models::square_root_cost(d7); });
}

TEST_CASE("The cost of a comparison is exact") {
  check_cost(k_compare_entry, 6, models::compare_cost);
}

TEST_CASE("The costs of changes and tests of sign are exact") {
  check_cost(k_negate_entry, 7,
             [](std::uint32_t d7, std::uint32_t) { return models::negate_cost(d7); });
  check_cost(k_absolute_entry, 8,
             [](std::uint32_t, std::uint32_t) { return models::absolute_cost(); });
  check_cost(k_test_entry, 9,
             [](std::uint32_t d7, std::uint32_t) { return models::test_cost(d7); });
}

TEST_CASE("The cost of a conversion to an integer is exact") {
  check_cost(k_to_integer_entry, 10,
             [](std::uint32_t d7, std::uint32_t) { return models::to_integer_cost(d7); });
}

TEST_CASE("The cost of a conversion from an integer is exact") {
  PackageProcessor processor;
  Bits bits(11);
  for (int i = 0; i < k_cases; ++i) {
    const std::uint32_t integer = any_integer(bits);
    const PackageCall call = processor.call(k_from_integer_entry, integer);
    const RoutineCost expected = models::from_integer_cost(integer);
    CAPTURE(integer);
    REQUIRE(expected.cycles == call.cycles);
    REQUIRE(expected.reads == call.reads);
    REQUIRE(expected.writes == call.writes);
  }
}

}  // namespace
}  // namespace maquette::tests
