#include "sim/database/board_link.hpp"

#include <algorithm>
#include <stdexcept>

#include "tests/catch.hpp"

using namespace maquette;

namespace {

constexpr firmware::NumberFormat k_formats[] = {firmware::NumberFormat::ffp,
                                                firmware::NumberFormat::ieee_single};

bool always(const firmware::CodePiece& /*piece*/) { return true; }

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

TEST_CASE("every address in the program of a board is that of what it names") {
  for (const firmware::NumberFormat numbers : k_formats) {
    const firmware::ProgramCode& code = sim::program_code(numbers);
    CHECK(code.numbers == numbers);
    const sim::LinkedProgram program = sim::linked_program(code, 0x2000, always);
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
}

TEST_CASE("a program elsewhere differs in its addresses alone") {
  for (const firmware::NumberFormat numbers : k_formats) {
    const firmware::ProgramCode& code = sim::program_code(numbers);
    const sim::LinkedProgram low = sim::linked_program(code, 0x2000, always);
    const sim::LinkedProgram high = sim::linked_program(code, 0x5000, always);
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
  const auto is_needed = [left_out](const firmware::CodePiece& piece) {
    return piece.name != left_out;
  };
  const firmware::ProgramCode& code = sim::program_code(firmware::NumberFormat::ffp);
  const sim::LinkedProgram all = sim::linked_program(code, 0x2000, always);
  const sim::LinkedProgram part = sim::linked_program(code, 0x2000, is_needed);
  const auto* const piece = std::find_if_not(code.pieces.begin(), code.pieces.end(), is_needed);
  REQUIRE(piece != code.pieces.end());
  CHECK(all.bytes.size() - part.bytes.size() == 2 * piece->words);
  CHECK_THROWS_AS(address_of(part, left_out), std::out_of_range);
  int calls = 0;
  for (std::size_t i = 0; i < code.pieces.size(); ++i) {
    const firmware::CodePiece& caller = code.pieces[i];
    for (std::uint32_t j = 0; j < caller.addresses && part.addresses[i] != 0; ++j) {
      const firmware::CodeAddress& address = code.addresses[caller.first_address + j];
      if (address.piece == static_cast<std::uint32_t>(piece - code.pieces.begin())) {
        ++calls;
        CHECK(long_at(part, part.addresses[i] + address.offset) % 2 == 1);
      }
    }
  }
  CHECK(calls > 0);
}

}  // namespace
