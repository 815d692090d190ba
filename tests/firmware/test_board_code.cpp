#include <string>

#include "firmware/board_code_ffp.hpp"
#include "firmware/board_code_ieee_single.hpp"
#include "firmware_version.hpp"
#include "tests/catch.hpp"

using namespace maquette;

namespace {

void check_pieces(const firmware::ProgramCode& code) {
  std::uint32_t words = 0;
  std::uint32_t addresses = 0;
  for (const firmware::CodePiece& piece : code.pieces) {
    CHECK(piece.first_word == words);
    CHECK(piece.first_address == addresses);
    for (std::uint32_t i = 0; i < piece.addresses; ++i) {
      const firmware::CodeAddress& address = code.addresses[piece.first_address + i];
      CHECK(address.offset % 2 == 0);
      CHECK(address.offset + 4 <= 2 * piece.words);
    }
    words += piece.words;
    addresses += piece.addresses;
  }
  CHECK(words == code.words.size());
  CHECK(addresses == code.addresses.size());
}

}  // namespace

TEST_CASE("The code of a board is made from the firmware as it is") {
  INFO("after a change of the firmware tools/board_code makes it again");
  const std::string version = firmware::k_firmware_version;
  CHECK(firmware::board_code_ffp::k_firmware_version == version);
  CHECK(firmware::board_code_ieee_single::k_firmware_version == version);
}

TEST_CASE("Pieces follow one another, and their addresses lie in them") {
  check_pieces(firmware::board_code_ffp::k_program);
  check_pieces(firmware::board_code_ieee_single::k_program);
}
