#include "models/bus/memory_cells.hpp"

#include <numeric>

#include "tests/catch.hpp"

namespace maquette::models {
namespace {

constexpr std::size_t k_cells = 16;

std::vector<unsigned char> counted_cells() {
  std::vector<unsigned char> cells(k_cells);
  std::iota(cells.begin(), cells.end(), static_cast<unsigned char>(0));
  return cells;
}

/// What an access to `cells` moves and answers.
struct Answer {
  unsigned bytes;
  tlm::tlm_response_status status;
};

Answer access(std::vector<unsigned char>& cells, tlm::tlm_command command, std::uint64_t address,
              std::vector<unsigned char>& data) {
  tlm::tlm_generic_payload payload;
  payload.set_command(command);
  payload.set_address(address);
  payload.set_data_ptr(data.data());
  payload.set_data_length(static_cast<unsigned>(data.size()));
  const unsigned bytes = access_cells(cells, payload);
  return {bytes, payload.get_response_status()};
}

}  // namespace

TEST_CASE("a memory reads and writes the bytes addressed and no others") {
  for (std::size_t address = 0; address < k_cells; ++address) {
    for (std::size_t bytes = 1; address + bytes <= k_cells; ++bytes) {
      std::vector<unsigned char> cells = counted_cells();
      std::vector<unsigned char> data(bytes, 0xAA);
      const Answer read = access(cells, tlm::TLM_READ_COMMAND, address, data);
      CHECK(read.bytes == bytes);
      CHECK(read.status == tlm::TLM_OK_RESPONSE);
      CHECK(cells == counted_cells());
      std::vector<unsigned char> expected = counted_cells();
      for (std::size_t i = 0; i < bytes; ++i) {
        CHECK(data[i] == address + i);
        data[i] = expected[address + i] = static_cast<unsigned char>(0x80 + i);
      }
      const Answer write = access(cells, tlm::TLM_WRITE_COMMAND, address, data);
      CHECK(write.bytes == bytes);
      CHECK(write.status == tlm::TLM_OK_RESPONSE);
      CHECK(cells == expected);
    }
  }
}

TEST_CASE("an access that ends beyond a memory moves nothing and is an address error") {
  for (const std::uint64_t address : {13ULL, 15ULL, 16ULL, 1000ULL, ~0ULL, ~0ULL - 2}) {
    for (const tlm::tlm_command command : {tlm::TLM_READ_COMMAND, tlm::TLM_WRITE_COMMAND}) {
      std::vector<unsigned char> cells = counted_cells();
      std::vector<unsigned char> data(4, 0xAA);
      const Answer answer = access(cells, command, address, data);
      CHECK(answer.bytes == 0);
      CHECK(answer.status == tlm::TLM_ADDRESS_ERROR_RESPONSE);
      CHECK(cells == counted_cells());
      CHECK(data == std::vector<unsigned char>(4, 0xAA));
    }
  }
}

}  // namespace maquette::models
