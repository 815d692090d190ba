#include "sim/database/board_code.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "firmware/facets/facet_table.hpp"
#include "firmware/primitives/conversion_table.hpp"
#include "sim/primitives/primitive_table.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/database/needs_cases.hpp"

using namespace maquette;
using tests::all_needs;

namespace {

using Names = std::vector<std::string>;

constexpr firmware::NumberFormat k_formats[] = {firmware::NumberFormat::ffp,
                                                firmware::NumberFormat::ieee_single};

const firmware::ProgramCode& k_code = sim::program_code(firmware::NumberFormat::ffp);

Names left_out(const sim::BoardPieces& pieces) {
  Names names;
  for (std::size_t i = 0; i < pieces.bytes.size(); ++i) {
    if (pieces.bytes[i] == 0) {
      names.emplace_back(pieces.code->pieces[i].name);
    }
  }
  return names;
}

/// Bytes of a namespace.
std::int64_t bytes_in(const sim::BoardPieces& pieces, std::string_view name) {
  std::int64_t bytes = 0;
  for (std::size_t i = 0; i < pieces.bytes.size(); ++i) {
    bytes += sim::is_in_namespace(pieces.code->pieces[i].name, name) ? pieces.bytes[i] : 0;
  }
  return bytes;
}

/// Each need of a scene or not, by chance.
firmware::Needs random_needs(firmware::trial::Random& random) {
  firmware::Needs needs{};
  const std::size_t count = sim::named_needs(needs).size();
  for (std::size_t i = 0; i < count; ++i) {
    needs = random.below(2) == 0 ? needs : sim::named_needs(needs)[i].with;
  }
  return needs;
}

/// Whether a function is for a parallel view alone, or also there in an instance for one.
bool is_of_parallel_view(const firmware::ProgramCode& code, const std::string& name) {
  return name.rfind("parallel_", 0) == 0 ||
         std::count_if(code.pieces.begin(), code.pieces.end(),
                       [&](const auto& piece) { return name == piece.name; }) > 1;
}

TEST_CASE(
    "a parallel view has functions of its own in place of others, and no other view has them") {
  firmware::trial::Random random(517);
  for (int trial = 0; trial < 20; ++trial) {
    firmware::Needs needs = random_needs(random);
    const sim::BoardPieces others = sim::needed_pieces(k_code, needs);
    needs.parallel_view = true;
    const sim::BoardPieces pieces = sim::needed_pieces(k_code, needs);
    for (std::uint32_t i = 0; i < pieces.bytes.size(); ++i) {
      const std::string name = k_code.pieces[i].name;
      INFO(name);
      REQUIRE(others.target(i) == i);
      if (name.rfind("parallel_", 0) == 0) {
        REQUIRE(others.bytes[i] == 0);
        REQUIRE((pieces.bytes[i] != 0 || (name == "parallel_cross_spans" && !needs.several_spans)));
      } else if (pieces.target(i) != i) {
        REQUIRE(pieces.bytes[i] == 0);
        REQUIRE((pieces.bytes[pieces.target(i)] != 0) == (others.bytes[i] != 0));
      }
    }
  }
}

TEST_CASE(
    "a scene that needs everything leaves out the interlace, a parallel view, and integer routines "
    "that nobody calls") {
  const Names routines = {"__mulsi3", "__udivsi3", "divide", "__umodsi3",
                          "__divsi3", "__modsi3",  "memset", "interlaced_synthesis"};
  for (const firmware::NumberFormat numbers : k_formats) {
    CHECK(sim::program_code(numbers).numbers == numbers);
    for (const std::string& name :
         left_out(sim::needed_pieces(sim::program_code(numbers), all_needs()))) {
      INFO(name);
      if (is_of_parallel_view(sim::program_code(numbers), name)) {
        continue;
      }
      CHECK(std::count(routines.begin(), routines.end(), name) == 1);
    }
  }
}

TEST_CASE("the beginning of the program and what it always calls is in every board") {
  const Names names = left_out(sim::needed_pieces(k_code, firmware::Needs{}));
  for (const std::string name : {"board_program", "board_synthesis", "follow", "cross"}) {
    CHECK(std::count(names.begin(), names.end(), name) == 0);
  }
}

TEST_CASE("boards convert what a scene gives where it has a primitive that is given otherwise") {
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    const auto primitive = static_cast<firmware::PrimitiveKind>(kind);
    INFO(kind);
    firmware::Needs needs{};
    needs.primitives[kind] = true;
    const Names names = left_out(sim::needed_pieces(k_code, needs));
    const auto missing = [&names](const char* name) {
      return std::count(names.begin(), names.end(), name) == 1;
    };
    const bool converts = firmware::conversion_of<float>(primitive) != nullptr;
    CHECK(missing("converting_program") != converts);
    CHECK(missing("k_conversions") != converts);
    CHECK_FALSE(missing("board_program"));
    const bool is_given_otherwise = primitive == firmware::kind_of<firmware::revolution::Kind> ||
                                    primitive == firmware::kind_of<firmware::shell::Kind> ||
                                    primitive == firmware::kind_of<firmware::patches::Kind> ||
                                    primitive == firmware::kind_of<firmware::terrain::Kind>;
    CHECK(is_given_otherwise == converts);
  }
}

TEST_CASE("boards of an interlace have its loop in place of the others', and call it") {
  using maquette::models::Allotment;
  firmware::trial::Random random(516);
  for (int trial = 0; trial < 20; ++trial) {
    const firmware::Needs needs = random_needs(random);
    const sim::BoardPieces others = sim::needed_pieces(k_code, needs);
    const sim::BoardPieces pieces = sim::needed_pieces(k_code, needs, Allotment::interlaced);
    for (std::uint32_t i = 0; i < pieces.bytes.size(); ++i) {
      const std::string_view name = k_code.pieces[i].name;
      INFO(name);
      if (name == "board_synthesis") {
        REQUIRE(pieces.bytes[i] == 0);
        REQUIRE(std::string_view{k_code.pieces[pieces.target(i)].name} == "interlaced_synthesis");
        REQUIRE(others.target(i) == i);
      } else if (name == "interlaced_synthesis") {
        REQUIRE(pieces.bytes[i] != 0);
        REQUIRE(others.bytes[i] == 0);
      } else {
        REQUIRE(pieces.bytes[i] == others.bytes[i]);
        REQUIRE(pieces.target(i) == i);
      }
    }
  }
}

TEST_CASE("a need takes nothing away, and a piece is there whole") {
  firmware::trial::Random random(515);
  const sim::BoardPieces all = sim::all_pieces(k_code);
  for (int trial = 0; trial < 50; ++trial) {
    const firmware::Needs needs = random_needs(random);
    const sim::BoardPieces pieces = sim::needed_pieces(k_code, needs);
    for (const sim::NamedNeed& need : sim::named_needs(needs)) {
      INFO(need.name);
      const sim::BoardPieces more = sim::needed_pieces(k_code, need.with);
      for (std::size_t i = 0; i < pieces.bytes.size(); ++i) {
        REQUIRE(more.bytes[i] >= pieces.bytes[i]);
        const std::string_view name = k_code.pieces[i].name;
        const bool is_table =
            name == "k_primitives" || name == "k_surface_maps" || name == "k_conversions";
        REQUIRE((pieces.bytes[i] == 0 || pieces.bytes[i] == all.bytes[i] || is_table));
      }
    }
  }
}

TEST_CASE("every need but ambient light makes a board hold more than no need at all") {
  const firmware::Needs all = all_needs();
  const auto whole = sim::code_bytes(sim::needed_pieces(k_code, all));
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    INFO(sim::primitive_table()[static_cast<std::size_t>(kind)]->name);
    firmware::Needs needs = all;
    needs.primitives[kind] = false;
    CHECK(sim::code_bytes(sim::needed_pieces(k_code, needs)) < whole);
  }
  for (int kind = 0; kind < firmware::k_facet_kind_count; ++kind) {
    INFO(firmware::k_facet_distributions.rows[kind].name);
    firmware::Needs needs = all;
    needs.facets[kind] = false;
    CHECK(sim::code_bytes(sim::needed_pieces(k_code, needs)) < whole);
  }
  for (int kind = 0; kind < firmware::k_texture_kind_count; ++kind) {
    INFO(firmware::k_textures.rows[kind].name);
    firmware::Needs needs = all;
    needs.textures[kind] = false;
    CHECK(sim::code_bytes(sim::needed_pieces(k_code, needs)) < whole);
  }
  using firmware::Needs;
  for (bool Needs::*need :
       {&Needs::several_spans, &Needs::unions, &Needs::large_unions, &Needs::intersections,
        &Needs::diffuse, &Needs::specular, &Needs::dielectrics, &Needs::metals,
        &Needs::transparency, &Needs::absorption, &Needs::lights, &Needs::shadows,
        &Needs::reflections, &Needs::depth, &Needs::surface_ambient, &Needs::shaped_lights,
        &Needs::textured, &Needs::samples}) {
    Needs needs = all;
    needs.*need = false;
    CHECK(sim::code_bytes(sim::needed_pieces(k_code, needs)) < whole);
  }
}

/// A need of pictures, which are laid by functions of the primitives.
void need_pictures(firmware::Needs& needs) {
  needs.textured = true;
  needs.textures[static_cast<int>(firmware::texture_kind_of<firmware::picture::Kind>)] = true;
}

TEST_CASE("a primitive takes code only from the scenes that need it") {
  constexpr std::int64_t k_row_bytes = 18;  // four addresses and a flag
  firmware::Needs none{};
  need_pictures(none);
  const sim::BoardPieces bare = sim::needed_pieces(k_code, none);
  const auto bare_bytes = sim::code_bytes(bare);
  for (int kind = 0; kind < firmware::k_primitive_kind_count; ++kind) {
    const std::string_view name = sim::primitive_table()[static_cast<std::size_t>(kind)]->name;
    INFO(name);
    CHECK(bytes_in(bare, name) == 0);
    firmware::Needs needs = none;
    needs.primitives[kind] = true;
    const sim::BoardPieces pieces = sim::needed_pieces(k_code, needs);
    firmware::Needs all = all_needs();
    // A shell has instances of its own of functions of a solid of revolution.
    all.primitives[static_cast<int>(firmware::kind_of<firmware::shell::Kind>)] = name == "shell";
    CHECK(bytes_in(pieces, name) == bytes_in(sim::needed_pieces(k_code, all), name));
    CHECK(sim::code_bytes(pieces) >=
          bare_bytes + bytes_in(pieces, name) + k_row_bytes * (kind + 1));
  }
}

TEST_CASE("code that several primitives share is there for each of them, and once for all") {
  const auto bytes_of = [](std::initializer_list<firmware::PrimitiveKind> kinds) {
    firmware::Needs needs{};
    for (const firmware::PrimitiveKind kind : kinds) {
      needs.primitives[static_cast<int>(kind)] = true;
    }
    return sim::needed_pieces(k_code, needs);
  };
  constexpr auto k_torus = firmware::kind_of<firmware::torus::Kind>;
  constexpr auto k_algebraic = firmware::kind_of<firmware::algebraic::Kind>;
  const sim::BoardPieces one = bytes_of({k_torus});
  const sim::BoardPieces other = bytes_of({k_algebraic});
  const sim::BoardPieces both = bytes_of({k_torus, k_algebraic});
  CHECK(bytes_in(one, "laguerre") > 0);
  CHECK(bytes_in(other, "laguerre") == bytes_in(one, "laguerre"));
  CHECK(bytes_in(both, "laguerre") == bytes_in(one, "laguerre"));
  CHECK(bytes_in(bytes_of({}), "laguerre") == 0);
}

}  // namespace
