#include "sim/database/board_code.hpp"

#include <algorithm>
#include "firmware/facets/facet_table.hpp"

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "tests/catch.hpp"

using namespace maquette;

namespace {

firmware::Needs all_needs() {
  firmware::Needs needs{};
  for (bool& primitive : needs.primitives) {
    primitive = true;
  }
  for (bool& distribution : needs.facets) {
    distribution = true;
  }
  needs.several_spans = true;
  needs.unions = needs.large_unions = needs.intersections = needs.differences = true;
  needs.diffuse = needs.specular = needs.dielectrics = needs.metals = true;
  needs.transparency = needs.absorption = needs.lights = needs.shadows = true;
  needs.ambient = needs.reflections = needs.depth = true;
  return needs;
}

}  // namespace

TEST_CASE("A scene that needs everything leaves no code out") {
  CHECK(sim::board_code_of(all_needs()).left_out_bytes == 0);
}

TEST_CASE("Needed and left out code make up the whole program") {
  const sim::BoardCode all = sim::board_code_of(all_needs());
  const sim::BoardCode none = sim::board_code_of(firmware::Needs{});
  CHECK(none.needed_bytes > 0);
  CHECK(none.needed_bytes + none.left_out_bytes == all.needed_bytes);
}

TEST_CASE("Every primitive and facet distribution can be left out on its own") {
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    INFO("primitive " << kind);
    firmware::Needs needs = all_needs();
    needs.primitives[kind] = false;
    CHECK(sim::board_code_of(needs).left_out_bytes > 0);
  }
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    INFO(firmware::k_facet_distributions.rows[kind].name);
    firmware::Needs needs = all_needs();
    needs.facets[kind] = false;
    CHECK(sim::board_code_of(needs).left_out_bytes > 0);
  }
}

TEST_CASE("A primitive takes code only from the scenes that need it") {
  const auto row =
      sim::board_function("k_primitives")->code_bytes / firmware::k_primitive_kind_count;
  const auto bare = sim::board_code_of(firmware::Needs{}).needed_bytes;
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    INFO("primitive " << kind);
    const sim::PrimitiveDescription& primitive =
        *sim::primitive_table()[static_cast<std::size_t>(kind)];
    std::int64_t own = row * std::max(0, kind + 1 - sim::k_resident_primitives);
    for (const firmware::BoardFunction& function : firmware::k_board_functions) {
      const bool is_shared = std::any_of(
          primitive.shared_code.begin(), primitive.shared_code.end(),
          [&](const sim::CodeList& list) {
            return std::any_of(list.begin(), list.end(), [&](const sim::CodeName& code) {
              return sim::holds(code.name, function.name);
            });
          });
      const bool is_own = sim::is_in_namespace(function.name, primitive.name);
      own += is_own || is_shared ? function.code_bytes : 0;
    }
    firmware::Needs needs{};
    needs.primitives[kind] = true;
    CHECK(sim::board_code_of(needs).needed_bytes == bare + own);
  }
}

TEST_CASE("A higher tree takes more stack, the same for every level") {
  const firmware::Needs needs{};
  const auto step = sim::board_stack_bytes(1, needs) - sim::board_stack_bytes(0, needs);
  CHECK(step > 0);
  CHECK(sim::board_stack_bytes(10, needs) == sim::board_stack_bytes(0, needs) + 10 * step);
}

TEST_CASE("Primitives with several spans take more stack than convex ones, only where needed") {
  firmware::Needs needs{};
  const auto convex = sim::board_stack_bytes(3, needs);
  needs.primitives[static_cast<int>(firmware::kind_of<firmware::cone::Kind>)] = true;
  CHECK(sim::board_stack_bytes(3, needs) == convex);
  needs.primitives[static_cast<int>(firmware::kind_of<firmware::revolution::Kind>)] = true;
  CHECK(sim::board_stack_bytes(3, needs) > convex + firmware::k_primitive_hit_limit * 6);
}
