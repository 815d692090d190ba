#include "sim/database/board_link.hpp"

#include <algorithm>
#include <string_view>

#include "tests/catch.hpp"

using namespace maquette;

namespace {

constexpr firmware::NumberFormat k_formats[] = {firmware::NumberFormat::ffp,
                                                firmware::NumberFormat::ieee_single};

std::uint32_t long_at(const sim::LinkedProgram& program, std::uint32_t address) {
  std::uint32_t value = 0;
  for (std::uint32_t byte = 0; byte < 4; ++byte) {
    value = value << 8U | program.bytes.at(address - program.base + byte);
  }
  return value;
}

/// Where what an address names begins, and how many bytes it has.
struct Home {
  std::uint32_t first;
  std::size_t bytes;
};

Home home_of(const firmware::CodeAddress& address, const sim::LinkedProgram& program) {
  const firmware::ProgramCode& code = *program.code;
  return address.piece == firmware::k_package
             ? Home{program.package, code.package.bytes.size()}
             : Home{program.addresses[address.piece], 2 * code.pieces[address.piece].words};
}

void check_addresses(const sim::LinkedProgram& program) {
  const firmware::ProgramCode& code = *program.code;
  for (std::size_t i = 0; i < code.pieces.size(); ++i) {
    const firmware::CodePiece& piece = code.pieces[i];
    for (std::uint32_t j = 0; j < piece.addresses; ++j) {
      const firmware::CodeAddress& address = code.addresses[piece.first_address + j];
      const std::uint32_t found = long_at(program, program.addresses[i] + address.offset);
      const Home home = home_of(address, program);
      CHECK(found >= home.first);
      CHECK(found < home.first + home.bytes);
    }
  }
}

TEST_CASE("every address in the program of a board is that of what it names") {
  for (const firmware::NumberFormat numbers : k_formats) {
    const firmware::ProgramCode& code = sim::program_code(numbers);
    CHECK(code.numbers == numbers);
    for (const std::uint32_t base : {0U, 0x2000U}) {
      check_addresses(sim::linked_program(base, sim::all_pieces(code)));
    }
  }
}

TEST_CASE("a program elsewhere differs in its addresses alone") {
  for (const firmware::NumberFormat numbers : k_formats) {
    const firmware::ProgramCode& code = sim::program_code(numbers);
    const sim::LinkedProgram low = sim::linked_program(0x2000, sim::all_pieces(code));
    const sim::LinkedProgram high = sim::linked_program(0x5000, sim::all_pieces(code));
    REQUIRE(low.bytes.size() == high.bytes.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < low.bytes.size(); ++i) {
      different += low.bytes[i] != high.bytes[i] ? 1 : 0;
    }
    CHECK(different > 0);
    CHECK(different <= 2 * code.addresses.size());
  }
}

TEST_CASE("what is left out takes no room, and who calls it comes to an odd address") {
  const std::string_view left_out = "follow";
  const firmware::ProgramCode& code = sim::program_code(firmware::NumberFormat::ffp);
  const sim::LinkedProgram all = sim::linked_program(0x2000, sim::all_pieces(code));
  const auto* const piece =
      std::find_if(code.pieces.begin(), code.pieces.end(),
                   [left_out](const auto& candidate) { return candidate.name == left_out; });
  REQUIRE(piece != code.pieces.end());
  sim::BoardPieces pieces = sim::all_pieces(code);
  pieces.bytes[static_cast<std::size_t>(piece - code.pieces.begin())] = 0;
  const sim::LinkedProgram part = sim::linked_program(0x2000, pieces);
  CHECK(all.bytes.size() - part.bytes.size() == 2 * piece->words);
  CHECK(address_of(all, left_out) != sim::k_left_out);
  CHECK(address_of(part, left_out) == sim::k_left_out);
  int calls = 0;
  for (std::size_t i = 0; i < code.pieces.size(); ++i) {
    const firmware::CodePiece& caller = code.pieces[i];
    for (std::uint32_t j = 0; j < caller.addresses && part.addresses[i] != sim::k_left_out; ++j) {
      const firmware::CodeAddress& address = code.addresses[caller.first_address + j];
      if (address.piece == static_cast<std::uint32_t>(piece - code.pieces.begin())) {
        ++calls;
        CHECK(long_at(part, part.addresses[i] + address.offset) % 2 == 1);
      }
    }
  }
  CHECK(calls > 0);
}

TEST_CASE("of a piece that is there in part, only that part is linked") {
  const firmware::ProgramCode& code = sim::program_code(firmware::NumberFormat::ffp);
  const auto* const table = std::find_if(
      code.pieces.begin(), code.pieces.end(),
      [](const auto& piece) { return std::string_view{"k_primitives"} == piece.name; });
  REQUIRE(table != code.pieces.end());
  sim::BoardPieces pieces = sim::all_pieces(code);
  const auto number = static_cast<std::size_t>(table - code.pieces.begin());
  const sim::LinkedProgram all = sim::linked_program(0x2000, pieces);
  pieces.bytes[number] = 50;
  const sim::LinkedProgram part = sim::linked_program(0x2000, pieces);
  CHECK(all.bytes.size() - part.bytes.size() == 2 * table->words - 50);
  for (std::uint32_t offset = 0; offset < 48; offset += 4) {
    CHECK(long_at(all, all.addresses[number] + offset) ==
          long_at(part, part.addresses[number] + offset));
  }
  CHECK(std::equal(code.package.bytes.begin(), code.package.bytes.end(),
                   part.bytes.begin() + (part.package - part.base)));
}

}  // namespace
