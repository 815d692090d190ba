#include "sim/database/board_link.hpp"

#include <algorithm>
#include <iterator>

#include "firmware/board_code.hpp"
#include "tests/catch.hpp"

using namespace maquette;

namespace {

std::uint32_t long_at(const sim::LinkedProgram& program, std::uint32_t address) {
  std::uint32_t value = 0;
  for (std::uint32_t byte = 0; byte < 4; ++byte) {
    value = value << 8U | program.bytes.at(address - program.base + byte);
  }
  return value;
}

TEST_CASE("every address in the program of a board is that of what it names") {
  const sim::LinkedProgram program = sim::linked_program(0x2000, sim::all_pieces());
  for (std::size_t i = 0; i < std::size(firmware::k_code_pieces); ++i) {
    const firmware::CodePiece& piece = firmware::k_code_pieces[i];
    for (std::uint32_t j = 0; j < piece.addresses; ++j) {
      const firmware::CodeAddress& address = firmware::k_code_addresses[piece.first_address + j];
      const std::uint32_t found = long_at(program, program.addresses[i] + address.offset);
      const bool in_package = address.piece == firmware::k_package;
      const std::uint32_t home = in_package ? program.package : program.addresses[address.piece];
      const std::uint32_t bytes = in_package ? std::size(firmware::maquette_ffp::k_package)
                                             : 2 * firmware::k_code_pieces[address.piece].words;
      CHECK(found >= home);
      CHECK(found < home + bytes);
    }
  }
}

TEST_CASE("a program elsewhere differs in its addresses alone") {
  const sim::LinkedProgram low = sim::linked_program(0x2000, sim::all_pieces());
  const sim::LinkedProgram high = sim::linked_program(0x5000, sim::all_pieces());
  REQUIRE(low.bytes.size() == high.bytes.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < low.bytes.size(); ++i) {
    different += low.bytes[i] != high.bytes[i] ? 1 : 0;
  }
  CHECK(different > 0);
  CHECK(different <= 2 * std::size(firmware::k_code_addresses));
}

TEST_CASE("what is left out takes no room, and who calls it comes to an odd address") {
  const std::string_view left_out = "follow";
  const sim::LinkedProgram all = sim::linked_program(0x2000, sim::all_pieces());
  const auto* const piece =
      std::find_if(std::begin(firmware::k_code_pieces), std::end(firmware::k_code_pieces),
                   [left_out](const auto& candidate) { return candidate.name == left_out; });
  REQUIRE(piece != std::end(firmware::k_code_pieces));
  sim::PieceBytes pieces = sim::all_pieces();
  pieces[static_cast<std::size_t>(piece - std::begin(firmware::k_code_pieces))] = 0;
  const sim::LinkedProgram part = sim::linked_program(0x2000, pieces);
  CHECK(all.bytes.size() - part.bytes.size() == 2 * piece->words);
  CHECK(address_of(all, left_out) != 0);
  CHECK(address_of(part, left_out) == 0);
  int calls = 0;
  for (std::size_t i = 0; i < std::size(firmware::k_code_pieces); ++i) {
    const firmware::CodePiece& caller = firmware::k_code_pieces[i];
    for (std::uint32_t j = 0; j < caller.addresses && part.addresses[i] != 0; ++j) {
      const firmware::CodeAddress& address = firmware::k_code_addresses[caller.first_address + j];
      if (address.piece ==
          static_cast<std::uint32_t>(piece - std::begin(firmware::k_code_pieces))) {
        ++calls;
        CHECK(long_at(part, part.addresses[i] + address.offset) % 2 == 1);
      }
    }
  }
  CHECK(calls > 0);
}

TEST_CASE("of a piece that is there in part, only that part is linked") {
  const auto* const table = std::find_if(
      std::begin(firmware::k_code_pieces), std::end(firmware::k_code_pieces),
      [](const auto& piece) { return std::string_view{"k_primitives"} == piece.name; });
  REQUIRE(table != std::end(firmware::k_code_pieces));
  sim::PieceBytes pieces = sim::all_pieces();
  const auto number = static_cast<std::size_t>(table - std::begin(firmware::k_code_pieces));
  const sim::LinkedProgram all = sim::linked_program(0x2000, pieces);
  pieces[number] = 50;
  const sim::LinkedProgram part = sim::linked_program(0x2000, pieces);
  CHECK(all.bytes.size() - part.bytes.size() == 2 * table->words - 50);
  for (std::uint32_t offset = 0; offset < 48; offset += 4) {
    CHECK(long_at(all, all.addresses[number] + offset) ==
          long_at(part, part.addresses[number] + offset));
  }
  CHECK(std::equal(std::begin(firmware::maquette_ffp::k_package),
                   std::end(firmware::maquette_ffp::k_package),
                   part.bytes.begin() + (part.package - part.base)));
}

}  // namespace
