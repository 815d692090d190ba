#include "sim/database/board_code.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "firmware/board_functions.hpp"
#include "firmware/primitives/patches.hpp"
#include "firmware/primitives/prism.hpp"
#include "firmware/primitives/revolution.hpp"
#include "firmware/primitives/terrain.hpp"

namespace maquette::sim {

namespace {

using firmware::Needs;
using firmware::PrimitiveKind;

/// A function, or all functions of a namespace, that only some scenes need.
struct OptionalCode {
  std::string_view name;
  bool (*is_needed)(const Needs& needs);
};

template <PrimitiveKind kind>
bool needs_primitive(const Needs& needs) {
  return needs.primitives[static_cast<int>(kind)];
}

bool needs_plane_cubics(const Needs& needs) {
  return needs_primitive<PrimitiveKind::revolution>(needs) ||
         needs_primitive<PrimitiveKind::prism>(needs);
}

bool needs_hit_order(const Needs& needs) {
  return needs_plane_cubics(needs) || needs_primitive<PrimitiveKind::patches>(needs);
}

bool needs_roots(const Needs& needs) {
  return needs_plane_cubics(needs) || needs_primitive<PrimitiveKind::algebraic>(needs);
}

bool needs_composites(const Needs& needs) {
  return needs.unions || needs.intersections || needs.differences;
}

bool needs_large_unions(const Needs& needs) { return needs.large_unions; }

bool needs_gloss(const Needs& needs) { return needs.specular && needs.lights; }

constexpr OptionalCode k_optional_code[] = {
    {"half_space::", needs_primitive<PrimitiveKind::half_space>},
    {"box::", needs_primitive<PrimitiveKind::box>},
    {"sphere::", needs_primitive<PrimitiveKind::sphere>},
    {"cylinder::", needs_primitive<PrimitiveKind::cylinder>},
    {"cone::", needs_primitive<PrimitiveKind::cone>},
    {"revolution::", needs_primitive<PrimitiveKind::revolution>},
    {"terrain::", needs_primitive<PrimitiveKind::terrain>},
    {"algebraic::", needs_primitive<PrimitiveKind::algebraic>},
    {"prism::", needs_primitive<PrimitiveKind::prism>},
    {"curve_point", needs_plane_cubics},
    {"nearest_parameter", needs_plane_cubics},
    {"value_at", needs_plane_cubics},
    {"change_at", needs_plane_cubics},
    {"polygon_of", needs_plane_cubics},
    {"times_derivative", needs_plane_cubics},
    {"sort", needs_hit_order},
    {"bisect", needs_roots},
    {"patches::", needs_primitive<PrimitiveKind::patches>},
    {"real_roots::", needs_roots},
    {"laguerre::", needs_roots},
    {"bernstein::", needs_roots},
    {"roots_of", needs_roots},
    {"polynomial_of", needs_roots},
    {"sign_changes", needs_roots},
    {"sign_of", needs_roots},
    {"cross_spans", [](const Needs& needs) { return needs.several_spans; }},
    {"against_boxes", needs_large_unions},
    {"slab_scale", needs_large_unions},
    {"entry_into", needs_large_unions},
    {"entry_of", needs_large_unions},
    {"shorten", needs_large_unions},
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
    {"cosine_power_distribution", [](const Needs& needs) { return needs.facets[0]; }},
    {"gaussian_distribution", [](const Needs& needs) { return needs.facets[1]; }},
    {"trowbridge_reitz_distribution", [](const Needs& needs) { return needs.facets[2]; }},
    {"logarithm", [](const Needs& needs) { return needs.facets[0]; }},
    {"exponential",
     [](const Needs& needs) { return needs.facets[0] || needs.facets[1] || needs.absorption; }},
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

bool is_of(std::string_view function, std::string_view optional) {
  const bool is_namespace = optional.substr(optional.size() - 1) == ":";
  return is_namespace ? function.substr(0, optional.size()) == optional : function == optional;
}

bool is_needed(std::string_view function, const Needs& needs) {
  const auto* const optional =
      std::find_if(std::begin(k_optional_code), std::end(k_optional_code),
                   [function](const OptionalCode& code) { return is_of(function, code.name); });
  return optional == std::end(k_optional_code) || optional->is_needed(needs);
}

const firmware::BoardFunction* find_function(std::string_view name) {
  const auto* const found = std::find_if(
      std::begin(firmware::k_board_functions), std::end(firmware::k_board_functions),
      [name](const firmware::BoardFunction& function) { return function.name == name; });
  return found == std::end(firmware::k_board_functions) ? nullptr : found;
}

std::int64_t frame_bytes(std::string_view function) {
  constexpr std::int64_t k_return_address_bytes = 4;
  const firmware::BoardFunction* found = find_function(function);
  return k_return_address_bytes + (found == nullptr ? 0 : found->stack_bytes);
}

/// A function on a chain of calls and how often it may stand there.
struct Link {
  std::string_view function;
  int times = 1;
};

/// The deepest chain of calls below a leaf of certain primitives.
struct LeafChain {
  bool (*is_needed)(const Needs& needs);
  std::array<Link, 10> links;
};

constexpr int k_isolation_depth = firmware::real_roots::k_bisection_limit<float> + 1;

constexpr LeafChain k_leaf_chains[] = {
    {[](const Needs& /*needs*/) { return true; },
     {{{"cross_convex"},
       {"cone::intersect"},
       {"hits_of"},
       {"transform_point"},
       {"transform_direction"}}}},
    {needs_primitive<PrimitiveKind::revolution>,
     {{{"cross_spans"},
       {"revolution::intersect"},
       {"revolution::intersect_node", firmware::revolution::k_tree_height + 1},
       {"revolution::intersect_section"},
       {"real_roots::isolate", k_isolation_depth},
       {"real_roots::add_isolated"},
       {"real_roots::add_between_ends"},
       {"laguerre::refined"}}}},
    {needs_primitive<PrimitiveKind::terrain>,
     {{{"cross_spans"},
       {"terrain::intersect"},
       {"terrain::follow_half"},
       {"terrain::follow_over", firmware::terrain::k_level_limit + 1},
       {"terrain::midpoints"},
       {"terrain::midpoint"}}}},
    {needs_primitive<PrimitiveKind::algebraic>,
     {{{"cross_spans"},
       {"algebraic::intersect"},
       {"roots_of"},
       {"real_roots::isolate", k_isolation_depth},
       {"real_roots::add_isolated"},
       {"real_roots::add_between_ends"},
       {"laguerre::refined"}}}},
    {needs_primitive<PrimitiveKind::prism>,
     {{{"cross_spans"},
       {"prism::intersect"},
       {"prism::cross_outline"},
       {"prism::cross_node", firmware::prism::k_tree_height + 1},
       {"real_roots::isolate", k_isolation_depth},
       {"real_roots::add_isolated"},
       {"real_roots::add_between_ends"},
       {"laguerre::refined"}}}},
    {needs_primitive<PrimitiveKind::patches>,
     {{{"cross_spans"},
       {"patches::intersect"},
       {"patches::intersect_node", firmware::patches::k_tree_height + 1},
       {"patches::intersect_patch"},
       {"patches::find_roots"},
       {"patches::isolate", firmware::patches::k_cell_bisection_limit<float> + 1},
       {"patches::is_undecided"},
       {"patches::winding_of"},
       {"patches::edge_crossings"},
       {"patches::crossings_of", firmware::patches::k_edge_bisection_limit<float> + 1}}}},
};

std::int64_t chain_bytes(const LeafChain& chain) {
  std::int64_t bytes = 0;
  for (const Link& link : chain.links) {
    bytes += link.function.empty() ? 0 : link.times * frame_bytes(link.function);
  }
  return bytes;
}

}  // namespace

BoardCode board_code_of(const Needs& needs) {
  BoardCode code{};
  for (const firmware::BoardFunction& function : firmware::k_board_functions) {
    (is_needed(function.name, needs) ? code.needed_bytes : code.left_out_bytes) +=
        function.code_bytes;
  }
  return code;
}

std::int64_t board_stack_bytes(int tree_height, const Needs& needs) {
  std::int64_t bytes = 0;
  for (const std::string_view function : {"synthesize", "luminance", "follow", "light_from"}) {
    bytes += frame_bytes(function);
  }
  std::int64_t deepest = 0;
  for (const LeafChain& chain : k_leaf_chains) {
    deepest = std::max(deepest, chain.is_needed(needs) ? chain_bytes(chain) : 0);
  }
  std::int64_t level = std::max(frame_bytes("cross"), frame_bytes("pass_node"));
  if (needs.large_unions) {
    level = std::max(level, frame_bytes("cross_nearest"));
    bytes += frame_bytes("cross_ahead");
  }
  return bytes + deepest + (tree_height + 1) * level;
}

}  // namespace maquette::sim
