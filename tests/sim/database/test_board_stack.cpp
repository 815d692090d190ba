#include "sim/database/board_stack.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/database/board_code.hpp"
#include "tests/catch.hpp"
#include "tests/sim/database/needs_cases.hpp"

using namespace maquette;

namespace {

std::int64_t stack_bytes(const firmware::Needs& needs, int tree_height,
                         firmware::NumberFormat numbers = firmware::NumberFormat::ffp) {
  return sim::board_stack_bytes(sim::needed_pieces(sim::program_code(numbers), needs), tree_height);
}

firmware::Needs needs_of(firmware::PrimitiveKind kind) {
  firmware::Needs needs{};
  needs.primitives[static_cast<int>(kind)] = true;
  needs.several_spans = !firmware::primitive_of<float>(kind).is_convex;
  return needs;
}

TEST_CASE("every function that calls itself says how deep") {
  CHECK_NOTHROW(stack_bytes(tests::all_needs(), 10));
  CHECK_NOTHROW(stack_bytes(tests::all_needs(), 10, firmware::NumberFormat::ieee_single));
}

TEST_CASE("a higher tree takes more stack, the same for every level") {
  for (const firmware::Needs& needs : {firmware::Needs{}, tests::all_needs()}) {
    const auto step = stack_bytes(needs, 1) - stack_bytes(needs, 0);
    CHECK(step > 0);
    CHECK(stack_bytes(needs, 10) == stack_bytes(needs, 0) + 10 * step);
  }
}

TEST_CASE("primitives with several spans take more stack than convex ones") {
  const auto convex = stack_bytes(needs_of(firmware::kind_of<firmware::cone::Kind>), 3);
  const auto spans = stack_bytes(needs_of(firmware::kind_of<firmware::revolution::Kind>), 3);
  CHECK(spans > convex + firmware::k_primitive_hit_limit * 6);
}

TEST_CASE("the stack of a scene that needs more is no smaller") {
  for (const sim::NamedNeed& need : sim::named_needs(firmware::Needs{})) {
    INFO(need.name);
    CHECK(stack_bytes(need.with, 2) >= stack_bytes(firmware::Needs{}, 2));
    CHECK(stack_bytes(need.with, 2) <= stack_bytes(tests::all_needs(), 2));
  }
}

}  // namespace
