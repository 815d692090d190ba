#include "sim/database/board_code.hpp"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <string_view>
#include <utility>

#include "firmware/board_code_ffp.hpp"
#include "firmware/board_code_ieee_single.hpp"
#include "firmware/facets/facet_table.hpp"
#include "firmware/primitives/conversion_table.hpp"
#include "firmware/textures/texture_table.hpp"
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
    {"metal_reflection", [](const Needs& needs) { return needs.metals; }},
    {"light_through", [](const Needs& needs) { return needs.transparency && needs.lights; }},
    {"transmitted_over", [](const Needs& needs) { return needs.absorption; }},
    {"pass_node", [](const Needs& needs) { return needs.shadows; }},
    {"pass_crossings", [](const Needs& needs) { return needs.shadows && needs.transparency; }},
    {"preprocessing::add_surface_ambients",
     [](const Needs& needs) { return needs.surface_ambient; }},
    {"preprocessing::prepare_light_axes", [](const Needs& needs) { return needs.shaped_lights; }},
    {"shaped_share", [](const Needs& needs) { return needs.shaped_lights; }},
    {"tint_of", [](const Needs& needs) { return needs.textured; }},
    {"sampled_luminance", [](const Needs& needs) { return needs.samples; }},
    {"depth_range", [](const Needs& needs) { return needs.depth; }},
    {"depth_code", [](const Needs& needs) { return needs.depth; }},
    {"spawn", [](const Needs& needs) { return needs.reflections; }},
    {"spawn_refracted", [](const Needs& needs) { return needs.reflections && needs.transparency; }},
};

/// Whether the program has a namespace for each row of a table.
template <class Table>
constexpr bool are_in_program(const Table& table) {
  for (const auto& row : table.rows) {
    if (!has_namespace(row.name)) {
      return false;
    }
  }
  return true;
}

static_assert(are_in_program(firmware::k_facet_distributions) &&
                  are_in_program(firmware::k_textures),
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
  for (int kind = 0; kind < firmware::k_texture_kind_count; ++kind) {
    const char* const texture = firmware::k_textures.rows[kind].name;
    open = open && (!is_in_namespace(function, texture) || needs.textures[kind]);
  }
  return open;
}

constexpr std::uint32_t bytes_of(const CodePiece& piece) { return 2 * piece.words; }

/// Tables of addresses with a row for each primitive, of which those that a scene needs are kept.
constexpr CodeName k_tables[] = {"k_primitives", "k_surface_maps", "k_conversions"};

bool is_primitive_table(std::string_view name) {
  return std::any_of(std::begin(k_tables), std::end(k_tables),
                     [name](const CodeName& table) { return table.name == name; });
}

/// Follows the addresses in a program.
class Reach {
 public:
  Reach(const firmware::ProgramCode& code, const Needs& needs,
        std::vector<BoardPieces::Detour> detours)
      : needs_(needs),
        pieces_{&code, std::vector<std::uint32_t>(code.pieces.size()), std::move(detours)} {}

  void add(std::uint32_t number) {
    const CodePiece& piece = pieces_.code->pieces[number];
    if (pieces_.bytes[number] != 0 || !is_open(piece.name, needs_)) {
      return;
    }
    const bool is_table = is_primitive_table(piece.name);
    const std::uint32_t row_bytes = bytes_of(piece) / firmware::k_primitive_kind_count;
    pieces_.bytes[number] = is_table ? row_bytes * needed_rows() : bytes_of(piece);
    for (std::uint32_t i = 0; i < piece.addresses; ++i) {
      const firmware::CodeAddress& address = pieces_.code->addresses[piece.first_address + i];
      const bool is_needed = !is_table || needs_.primitives[address.offset / row_bytes];
      if (address.piece != firmware::k_package && is_needed &&
          is_open(pieces_.code->pieces[address.piece].name, needs_)) {
        add(pieces_.target(address.piece));
      }
    }
  }

  [[nodiscard]] const BoardPieces& pieces() const { return pieces_; }

 private:
  [[nodiscard]] std::uint32_t needed_rows() const {
    std::uint32_t rows = 0;
    for (std::uint32_t kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
      rows = needs_.primitives[kind] ? kind + 1 : rows;
    }
    return rows;
  }

  const Needs& needs_;
  BoardPieces pieces_;
};

constexpr CodeName k_beginning = "board_program";
constexpr CodeName k_converting_beginning = "converting_program";
constexpr CodeName k_synthesis = "board_synthesis";
constexpr CodeName k_interlaced_synthesis = "interlaced_synthesis";

/// Whether there is a primitive whose parameters boards make of what is given.
bool converts(const Needs& needs) {
  bool any = false;
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    const auto primitive = static_cast<firmware::PrimitiveKind>(kind);
    any = any || (needs.primitives[kind] && firmware::conversion_of<float>(primitive) != nullptr);
  }
  return any;
}

std::uint32_t number_of(const firmware::ProgramCode& code, const CodeName& piece) {
  const auto* const found =
      std::find_if(code.pieces.begin(), code.pieces.end(),
                   [&piece](const CodePiece& other) { return piece.name == other.name; });
  return static_cast<std::uint32_t>(found - code.pieces.begin());
}

/// Functions, and what a parallel view has in their place.
struct Replacement {
  CodeName from;
  CodeName to;
};

constexpr Replacement k_of_parallel_view[] = {
    {"preprocessing::projected", "parallel_projected"},
    {"cross_convex", "parallel_cross_convex"},
    {"cross_spans", "parallel_cross_spans"},
    {"face_point", "parallel_face_point"},
    {"synthesize_unit", "parallel_synthesize_unit"},
};

std::vector<BoardPieces::Detour> detours_of(const firmware::ProgramCode& code, const Needs& needs,
                                            models::Allotment order) {
  std::vector<BoardPieces::Detour> detours;
  if (order == models::Allotment::interlaced) {
    detours.push_back({number_of(code, k_synthesis), number_of(code, k_interlaced_synthesis)});
  }
  if (needs.parallel_view) {
    for (const Replacement& replacement : k_of_parallel_view) {
      detours.push_back({number_of(code, replacement.from), number_of(code, replacement.to)});
    }
  }
  return detours;
}

}  // namespace

const firmware::ProgramCode& program_code(firmware::NumberFormat numbers) {
  return numbers == firmware::NumberFormat::ffp ? firmware::board_code_ffp::k_program
                                                : firmware::board_code_ieee_single::k_program;
}

BoardPieces all_pieces(const firmware::ProgramCode& code) {
  BoardPieces pieces{&code, {}};
  for (const CodePiece& piece : code.pieces) {
    pieces.bytes.push_back(bytes_of(piece));
  }
  return pieces;
}

BoardPieces needed_pieces(const firmware::ProgramCode& code, const Needs& needs,
                          models::Allotment order) {
  Reach reach(code, needs, detours_of(code, needs, order));
  reach.add(number_of(code, converts(needs) ? k_converting_beginning : k_beginning));
  return reach.pieces();
}

std::int64_t code_bytes(const BoardPieces& pieces) {
  return std::accumulate(pieces.bytes.begin(), pieces.bytes.end(), std::int64_t{0});
}

}  // namespace maquette::sim
