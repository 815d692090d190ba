#include "firmware/board_code.hpp"

#include <iterator>
#include <string>

#include "firmware_version.hpp"
#include "tests/catch.hpp"

using namespace maquette;

TEST_CASE("The code of a board is made from the firmware as it is") {
  INFO("after a change of the firmware tools/board_code makes it again");
  CHECK(std::string(firmware::k_board_code_version) == firmware::k_firmware_version);
}

TEST_CASE("Pieces follow one another, and their addresses lie in them") {
  std::uint32_t words = 0;
  std::uint32_t addresses = 0;
  for (const firmware::CodePiece& piece : firmware::k_code_pieces) {
    CHECK(piece.first_word == words);
    CHECK(piece.first_address == addresses);
    for (std::uint32_t i = 0; i < piece.addresses; ++i) {
      const firmware::CodeAddress& address = firmware::k_code_addresses[piece.first_address + i];
      CHECK(address.offset % 2 == 0);
      CHECK(address.offset + 4 <= 2 * piece.words);
    }
    words += piece.words;
    addresses += piece.addresses;
  }
  CHECK(words == std::size(firmware::k_code_words));
  CHECK(addresses == std::size(firmware::k_code_addresses));
}
