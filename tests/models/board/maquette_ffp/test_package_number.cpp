#include "models/board/maquette_ffp/package_number.hpp"

#include "firmware/arithmetic/maquette_ffp/package.hpp"
#include "models/board/maquette_ffp/package_processor.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/arithmetic/maquette_ffp/operands.hpp"

namespace maquette::tests {
namespace {

using models::PackageMeter;
using models::PackageNumber;

/// What an operation adds to the meter of this thread.
template <class Operation>
PackageMeter taken_by(Operation operation) {
  const PackageMeter before = models::package_meter();
  operation();
  const PackageMeter& after = models::package_meter();
  return {after.calls - before.calls, after.cycles - before.cycles, after.reads - before.reads,
          after.writes - before.writes};
}

/// An operation takes one call of a routine with the same operands. Returns the writes of all.
template <class Operation>
std::uint64_t check_call(std::uint32_t entry, Operation operation) {
  models::PackageProcessor processor;
  Bits bits(entry);
  std::uint64_t writes = 0;
  for (int i = 0; i < 500; ++i) {
    const Operands operands = any_operands(bits);
    const models::PackageCall call = processor.call(entry, operands.d7, operands.d6);
    const PackageNumber a = PackageNumber::of_bits(operands.d7);
    const PackageNumber b = PackageNumber::of_bits(operands.d6);
    const PackageMeter taken = taken_by([&] { operation(a, b); });
    REQUIRE(taken.calls == 1);
    REQUIRE(taken.cycles == call.cycles);
    REQUIRE(taken.reads == call.reads);
    REQUIRE(taken.writes == call.writes);
    writes += taken.writes;
  }
  return writes;
}

}  // namespace

TEST_CASE("An operation takes what its routine takes on the processor") {
  using namespace firmware::maquette_ffp;
  std::uint64_t writes =
      check_call(k_add_entry, [](PackageNumber a, PackageNumber b) { return a + b; });
  writes += check_call(k_subtract_entry, [](PackageNumber a, PackageNumber b) { return a - b; });
  writes += check_call(k_multiply_entry, [](PackageNumber a, PackageNumber b) { return a * b; });
  writes += check_call(k_divide_entry, [](PackageNumber a, PackageNumber b) { return a / b; });
  writes += check_call(k_negate_entry, [](PackageNumber a, PackageNumber) { return -a; });
  writes += check_call(k_compare_entry, [](PackageNumber a, PackageNumber b) { return a < b; });
  writes += check_call(k_compare_entry, [](PackageNumber a, PackageNumber b) { return a <= b; });
  CHECK(writes > 0);
}

TEST_CASE("Constants and conversions of integers take nothing") {
  const PackageMeter taken =
      taken_by([] { return PackageNumber(0.1F).bits + PackageNumber(7).bits; });
  CHECK(taken.calls == 0);
  CHECK(taken.cycles == 0);
}

TEST_CASE("Numbers are in the order of the floats that they stand for, and equal ones are alike") {
  Bits bits(21);
  for (int i = 0; i < 2000; ++i) {
    const Operands operands = any_operands(bits);
    const PackageNumber a = PackageNumber::of_bits(operands.d7);
    const PackageNumber b = PackageNumber::of_bits(i % 8 == 0 ? operands.d7 : operands.d6);
    const float x = value_of(a);
    const float y = value_of(b);
    REQUIRE((a < b) == (x < y));
    REQUIRE((a <= b) == (x <= y));
    REQUIRE((a > b) == (x > y));
    REQUIRE((a >= b) == (x >= y));
  }
}

}  // namespace maquette::tests
