#include "firmware/boolean_operator.hpp"

#include "firmware/combine.hpp"
#include "tests/catch.hpp"

namespace maquette::firmware {
namespace {

constexpr SurfaceIndex k_red = 0;
constexpr SurfaceIndex k_blue = 1;
constexpr BooleanOperator k_operators[] = {BooleanOperator::union_of, BooleanOperator::intersection,
                                           BooleanOperator::difference};

SurfaceIndex medium_of(BooleanOperator combination, SurfaceIndex a, SurfaceIndex b) {
  const Surface<float> surfaces[2] = {};
  return combined_medium(combination, surfaces, a, b);
}

}  // namespace

TEST_CASE("an operator keeps the regions where it leaves matter") {
  for (const BooleanOperator combination : k_operators) {
    const KeptRegions kept = kept_by(combination);
    CHECK(medium_of(combination, k_red, k_void) == (kept.first_alone ? k_red : k_void));
    CHECK(medium_of(combination, k_void, k_red) == (kept.second_alone ? k_red : k_void));
    CHECK((medium_of(combination, k_red, k_red) == k_red) == kept.overlap);
    CHECK(medium_of(combination, k_void, k_void) == k_void);
  }
}

TEST_CASE("the operators that boards compare with have by themselves what they stand for") {
  for (const BooleanOperator combination : k_operators) {
    const KeptRegions kept = kept_by(combination);
    const bool keeps_all = kept.first_alone && kept.second_alone && kept.overlap;
    CHECK((combination == k_drops_first) == !kept.first_alone);
    CHECK((combination == k_keeps_second) == kept.second_alone);
    CHECK((combination == k_keeps_all) == keeps_all);
  }
}

TEST_CASE("matter of the second operand is seen where it is kept alone, and nowhere else") {
  for (const BooleanOperator combination : k_operators) {
    const bool shows_second = medium_of(combination, k_void, k_blue) == k_blue;
    CHECK(shows_second == (combination == k_keeps_second));
    // Blue is declared after red: of a common region it shows where red is the second's.
    CHECK((medium_of(combination, k_blue, k_red) == k_red) == shows_second);
  }
}

TEST_CASE("a number that is no operator's keeps nothing") {
  for (int number = 3; number < k_boolean_operator_limit; ++number) {
    const KeptRegions kept = kept_by(static_cast<BooleanOperator>(number));
    CHECK_FALSE((kept.first_alone || kept.second_alone || kept.overlap));
  }
}

}  // namespace maquette::firmware
