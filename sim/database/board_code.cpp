#include "sim/database/board_code.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

#include "firmware/board_functions.hpp"
#include "firmware/facets/facet_table.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

using firmware::Needs;

/// A function that only some scenes need. What only some primitives or distributions of facets
/// need, their descriptions name.
struct OptionalCode {
  CodeName code;
  bool (*is_needed)(const Needs& needs);
};

bool needs_composites(const Needs& needs) {
  return needs.unions || needs.intersections || needs.differences;
}

bool needs_large_unions(const Needs& needs) { return needs.large_unions; }

bool needs_gloss(const Needs& needs) { return needs.specular && needs.lights; }

constexpr OptionalCode k_optional_code[] = {
    {"cross_spans", [](const Needs& needs) { return needs.several_spans; }},
    {"against_boxes", needs_large_unions},
    {"slab_scale", needs_large_unions},
    {"entry_into", needs_large_unions},
    {"entry_of", needs_large_unions},
    {"cross_nearest", needs_large_unions},
    {"cross_ahead", needs_large_unions},
    {"combine", needs_composites},
    {"OperandCursor::take", needs_composites},
    {"united", [](const Needs& needs) { return needs.unions; }},
    {"common", [](const Needs& needs) { return needs.intersections; }},
    {"preprocessing::prepare_surfaces", [](const Needs& needs) { return needs.diffuse; }},
    {"light_from", [](const Needs& needs) { return needs.lights; }},
    {"glossy_reflection", needs_gloss},
    {"facet_term", needs_gloss},
    {"fresnel_factor", [](const Needs& needs) { return needs.specular; }},
    {"dielectric_border", [](const Needs& needs) { return needs.dielectrics; }},
    {"conductor_reflection", [](const Needs& needs) { return needs.metals; }},
    {"exponential", [](const Needs& needs) { return needs.absorption; }},
    {"glossy_transmission", [](const Needs& needs) { return needs.transparency && needs.lights; }},
    {"transmitted_over", [](const Needs& needs) { return needs.absorption; }},
    {"pass_node", [](const Needs& needs) { return needs.shadows; }},
    {"pass_crossings", [](const Needs& needs) { return needs.shadows && needs.transparency; }},
    {"pass_surface", [](const Needs& needs) { return needs.shadows && needs.transparency; }},
    {"far_departure", [](const Needs& needs) { return needs.transparency; }},
    {"depth_range", [](const Needs& needs) { return needs.depth; }},
    {"depth_code", [](const Needs& needs) { return needs.depth; }},
    {"spawn", [](const Needs& needs) { return needs.reflections; }},
    {"spawn_reflected", [](const Needs& needs) { return needs.reflections; }},
    {"spawn_refracted", [](const Needs& needs) { return needs.reflections && needs.transparency; }},
};

bool is_called_by(const PrimitiveDescription& primitive, std::string_view function) {
  const auto holds_function = [function](const CodeName& code) {
    return holds(code.name, function);
  };
  return is_in_namespace(function, primitive.name) ||
         std::any_of(primitive.shared_code.begin(), primitive.shared_code.end(),
                     [&](const CodeList& list) {
                       return std::any_of(list.begin(), list.end(), holds_function);
                     });
}

/// Whether a row of the table of distributions names code that the board's program has.
constexpr bool is_in_program(const firmware::FacetDistribution& facets) {
  for (const char* call : facets.calls) {
    if (call != nullptr && !has_code(call)) {
      return false;
    }
  }
  return has_namespace(facets.name);
}

constexpr bool are_in_program(const firmware::FacetTable& table) {
  for (const firmware::FacetDistribution& facets : table.rows) {
    if (!is_in_program(facets)) {
      return false;
    }
  }
  return true;
}

static_assert(are_in_program(firmware::k_facet_distributions),
              "the program of a board has no such function");

bool is_called_by(const firmware::FacetDistribution& facets, std::string_view function) {
  return is_in_namespace(function, facets.name) ||
         std::any_of(std::begin(facets.calls), std::end(facets.calls),
                     [&](const char* call) { return call != nullptr && function == call; });
}

constexpr std::string_view k_table = "k_primitives";
constexpr std::int64_t k_table_bytes = board_function(k_table)->code_bytes;
static_assert(k_table_bytes % firmware::k_primitive_kind_count == 0);

/// Rows of the table of primitives, whose places are the kinds, up to the last that the scene
/// needs.
std::int64_t needed_table_bytes(const Needs& needs) {
  int rows = k_resident_primitives;
  for (int kind = rows; kind < firmware::k_primitive_kind_count; ++kind) {
    rows = needs.primitives[kind] ? kind + 1 : rows;
  }
  return k_table_bytes / firmware::k_primitive_kind_count * rows;
}

}  // namespace

bool is_needed(std::string_view function, const Needs& needs) {
  bool is_optional = false;
  bool is_called = false;
  const auto add = [&](bool calls, bool is_caller_needed) {
    is_optional = is_optional || calls;
    is_called = is_called || (calls && is_caller_needed);
  };
  for (std::size_t kind = 0; kind < primitive_table().size(); ++kind) {
    add(is_called_by(*primitive_table()[kind], function), needs.primitives[kind]);
  }
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    add(is_called_by(firmware::k_facet_distributions.rows[kind], function), needs.facets[kind]);
  }
  for (const OptionalCode& optional : k_optional_code) {
    add(holds(optional.code.name, function), optional.is_needed(needs));
  }
  return is_called || !is_optional;
}

namespace {

std::int64_t needed_bytes(const firmware::BoardFunction& function, const Needs& needs) {
  if (function.name == k_table) {
    return needed_table_bytes(needs);
  }
  return is_needed(function.name, needs) ? function.code_bytes : 0;
}

std::int64_t chain_bytes(const CallChain& chain) {
  constexpr std::int64_t k_return_address_bytes = 4;
  std::int64_t bytes = 0;
  for (const Call& call : chain) {
    bytes += call.times * (k_return_address_bytes + call.function->stack_bytes);
  }
  return bytes;
}

constexpr Call k_pixel_calls[] = {{"synthesize"}, {"luminance"}, {"follow"}, {"light_from"}};
constexpr Call k_cross_call[] = {{"cross"}};
constexpr Call k_shadow_call[] = {{"pass_node"}};
constexpr Call k_nearest_call[] = {{"cross_nearest"}};
constexpr Call k_ahead_call[] = {{"cross_ahead"}};

/// Whether the stack has room for the calls below a leaf of a primitive: of a resident convex one
/// in every scene.
bool has_room_for_calls(int kind, const Needs& needs) {
  const bool is_convex = firmware::k_primitives<float>.rows[kind].is_convex;
  return needs.primitives[kind] || (kind < k_resident_primitives && is_convex);
}

}  // namespace

BoardCode board_code_of(const Needs& needs) {
  BoardCode code{};
  for (const firmware::BoardFunction& function : firmware::k_board_functions) {
    const std::int64_t needed = needed_bytes(function, needs);
    code.needed_bytes += needed;
    code.left_out_bytes += function.code_bytes - needed;
  }
  return code;
}

std::int64_t board_stack_bytes(int tree_height, const Needs& needs) {
  std::int64_t deepest = 0;
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    if (has_room_for_calls(kind, needs)) {
      const PrimitiveDescription& primitive = *primitive_table()[static_cast<std::size_t>(kind)];
      deepest = std::max(deepest, chain_bytes(primitive.call_chain));
    }
  }
  std::int64_t bytes = chain_bytes(k_pixel_calls) + deepest;
  std::int64_t level = std::max(chain_bytes(k_cross_call), chain_bytes(k_shadow_call));
  if (needs.large_unions) {
    level = std::max(level, chain_bytes(k_nearest_call));
    bytes += chain_bytes(k_ahead_call);
  }
  return bytes + (tree_height + 1) * level;
}

}  // namespace maquette::sim
