#include "sim/database/board_code.hpp"

#include <iterator>
#include <numeric>
#include <string_view>

#include "firmware/board_code.hpp"
#include "firmware/facets/facet_table.hpp"
#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/board_call.hpp"

namespace maquette::sim {

namespace {

using firmware::CodePiece;
using firmware::Needs;

/// A function before whose call the firmware asks whether it is needed. What can be called from
/// there alone is left out with it.
struct Gate {
  CodeName code;
  bool (*is_open)(const Needs& needs);
};

constexpr Gate k_gates[] = {
    {"cross_spans", [](const Needs& needs) { return needs.several_spans; }},
    {"against_boxes", [](const Needs& needs) { return needs.large_unions; }},
    {"entry_into", [](const Needs& needs) { return needs.large_unions; }},
    {"cross_ahead", [](const Needs& needs) { return needs.large_unions; }},
    {"combine",
     [](const Needs& needs) { return needs.unions || needs.intersections || needs.differences; }},
    {"united", [](const Needs& needs) { return needs.unions; }},
    {"common", [](const Needs& needs) { return needs.intersections; }},
    {"preprocessing::prepare_surfaces", [](const Needs& needs) { return needs.diffuse; }},
    {"light_from", [](const Needs& needs) { return needs.lights; }},
    {"glossy_reflection", [](const Needs& needs) { return needs.specular && needs.lights; }},
    {"fresnel_factor", [](const Needs& needs) { return needs.specular; }},
    {"dielectric_border", [](const Needs& needs) { return needs.dielectrics; }},
    {"conductor_reflection", [](const Needs& needs) { return needs.metals; }},
    {"glossy_transmission", [](const Needs& needs) { return needs.transparency && needs.lights; }},
    {"transmitted_over", [](const Needs& needs) { return needs.absorption; }},
    {"pass_node", [](const Needs& needs) { return needs.shadows; }},
    {"pass_crossings", [](const Needs& needs) { return needs.shadows && needs.transparency; }},
    {"depth_range", [](const Needs& needs) { return needs.depth; }},
    {"depth_code", [](const Needs& needs) { return needs.depth; }},
    {"spawn", [](const Needs& needs) { return needs.reflections; }},
    {"spawn_refracted", [](const Needs& needs) { return needs.reflections && needs.transparency; }},
};

constexpr bool are_in_program(const firmware::FacetTable& table) {
  for (const firmware::FacetDistribution& facets : table.rows) {
    if (!has_namespace(facets.name)) {
      return false;
    }
  }
  return true;
}

static_assert(are_in_program(firmware::k_facet_distributions),
              "the program of a board has no such namespace");

bool is_open(std::string_view function, const Needs& needs) {
  bool open = true;
  for (const Gate& gate : k_gates) {
    open = open && (function != gate.code.name || gate.is_open(needs));
  }
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    const char* const facets = firmware::k_facet_distributions.rows[kind].name;
    open = open && (!is_in_namespace(function, facets) || needs.facets[kind]);
  }
  return open;
}

constexpr std::uint32_t bytes_of(const CodePiece& piece) { return 2 * piece.words; }

constexpr CodeName k_table = "k_primitives";

constexpr std::uint32_t table_row_bytes() {
  for (const CodePiece& piece : firmware::k_code_pieces) {
    if (k_table.name == piece.name) {
      return bytes_of(piece) / firmware::k_primitive_kind_count;
    }
  }
  return 0;
}

constexpr std::uint32_t k_row_bytes = table_row_bytes();

/// Follows the addresses in the program.
class Reach {
 public:
  explicit Reach(const Needs& needs) : needs_(needs), pieces_(std::size(firmware::k_code_pieces)) {}

  void add(std::uint32_t number) {
    const CodePiece& piece = firmware::k_code_pieces[number];
    if (pieces_[number] != 0 || !is_open(piece.name, needs_)) {
      return;
    }
    const bool is_table = k_table.name == piece.name;
    pieces_[number] = is_table ? needed_table_bytes() : bytes_of(piece);
    for (std::uint32_t i = 0; i < piece.addresses; ++i) {
      const firmware::CodeAddress& address = firmware::k_code_addresses[piece.first_address + i];
      const bool is_needed = !is_table || needs_.primitives[address.offset / k_row_bytes];
      if (address.piece != firmware::k_package && is_needed) {
        add(address.piece);
      }
    }
  }

  [[nodiscard]] const PieceBytes& pieces() const { return pieces_; }

 private:
  [[nodiscard]] std::uint32_t needed_table_bytes() const {
    std::uint32_t rows = 0;
    for (std::uint32_t kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
      rows = needs_.primitives[kind] ? kind + 1 : rows;
    }
    return rows * k_row_bytes;
  }

  const Needs& needs_;
  PieceBytes pieces_;
};

constexpr CodeName k_beginning = "board_program";

}  // namespace

PieceBytes all_pieces() {
  PieceBytes pieces;
  for (const CodePiece& piece : firmware::k_code_pieces) {
    pieces.push_back(bytes_of(piece));
  }
  return pieces;
}

PieceBytes needed_pieces(const Needs& needs) {
  Reach reach(needs);
  for (std::uint32_t number = 0; number < std::size(firmware::k_code_pieces); ++number) {
    if (k_beginning.name == firmware::k_code_pieces[number].name) {
      reach.add(number);
    }
  }
  return reach.pieces();
}

std::int64_t code_bytes(const PieceBytes& pieces) {
  return std::accumulate(pieces.begin(), pieces.end(), std::int64_t{0});
}

}  // namespace maquette::sim
