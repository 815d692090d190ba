#include "sim/database/board_link.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "tests/catch.hpp"

using namespace maquette;

namespace {

bool always(const firmware::CodePiece& /*piece*/) { return true; }

std::uint32_t long_at(const sim::LinkedProgram& program, std::uint32_t address) {
  std::uint32_t value = 0;
  for (std::uint32_t byte = 0; byte < 4; ++byte) {
    value = value << 8U | program.bytes.at(address - program.base + byte);
  }
  return value;
}

TEST_CASE("every address in the program of a board is that of what it names") {
  const sim::LinkedProgram program = sim::linked_program(0x2000, always);
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
  const sim::LinkedProgram low = sim::linked_program(0x2000, always);
  const sim::LinkedProgram high = sim::linked_program(0x5000, always);
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
  const auto is_needed = [left_out](const firmware::CodePiece& piece) {
    return piece.name != left_out;
  };
  const sim::LinkedProgram all = sim::linked_program(0x2000, always);
  const sim::LinkedProgram part = sim::linked_program(0x2000, is_needed);
  const auto* const piece = std::find_if_not(std::begin(firmware::k_code_pieces),
                                             std::end(firmware::k_code_pieces), is_needed);
  REQUIRE(piece != std::end(firmware::k_code_pieces));
  CHECK(all.bytes.size() - part.bytes.size() == 2 * piece->words);
  CHECK_THROWS_AS(address_of(part, left_out), std::out_of_range);
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

}  // namespace
