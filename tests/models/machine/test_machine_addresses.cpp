#include "models/machine/machine_addresses.hpp"

#include "tests/catch.hpp"

namespace maquette::models {
namespace {

constexpr std::uint64_t k_mbyte = 0x100000;

MachineAddresses addresses(std::size_t boards, std::int64_t ram_bytes, std::size_t shared = 0) {
  MachineParameters parameters;
  parameters.boards.resize(boards);
  parameters.board.ram_bytes = ram_bytes;
  return machine_addresses(parameters, shared);
}

}  // namespace

TEST_CASE("a board's block is the least power of two from 256 Kbyte on that holds its RAM") {
  CHECK(addresses(1, 1).block == 0x40000);
  CHECK(addresses(1, 0x40000).block == 0x40000);
  CHECK(addresses(1, 0x40001).block == 0x80000);
  CHECK(addresses(1, 3 * 0x100000).block == 4 * k_mbyte);
}

TEST_CASE("the frame memory is at 8 Mbyte, or behind boards that reach farther") {
  CHECK(addresses(4, 0x20000).frame.base == 8 * k_mbyte);
  CHECK(addresses(31, 0x20000).frame.base == 8 * k_mbyte);
  CHECK(addresses(32, 0x20000).frame.base == 8 * k_mbyte + 0x40000);
  CHECK(addresses(7, k_mbyte).frame.base == 8 * k_mbyte);
  CHECK(addresses(8, k_mbyte).frame.base == 9 * k_mbyte);
}

TEST_CASE("boards, frame memory and shared memory follow one another and do not overlap") {
  for (const std::size_t boards : {1U, 4U, 31U, 32U, 64U}) {
    for (const std::int64_t ram_bytes : {0x1000, 0x20000, 0x40001, 0x180000}) {
      const MachineAddresses places = addresses(boards, ram_bytes, 5000);
      const MachineParameters machine;
      const std::uint64_t frame_bytes = 4ULL *
                                        static_cast<std::uint64_t>(machine.frame_memory.width) *
                                        static_cast<std::uint64_t>(machine.frame_memory.height);
      CHECK(places.ram(0) >= static_cast<std::uint64_t>(ram_bytes));
      CHECK(places.ram(boards - 1) + places.block <= places.frame.base);
      const std::uint64_t frame_end = places.frame.base + frame_bytes;
      CHECK(places.shared.base >= frame_end);
      CHECK(places.shared.base - frame_end < places.block);
      CHECK(places.shared.base % places.block == 0);
      CHECK(places.shared.database_bytes == 5000);
    }
  }
}

TEST_CASE("a frame memory of whole blocks leaves no gap before the shared memory") {
  MachineParameters parameters;
  parameters.boards.resize(4);
  parameters.frame_memory.width = parameters.frame_memory.height = 512;
  CHECK(machine_addresses(parameters, 1).shared.base == 9 * k_mbyte);
}

}  // namespace maquette::models
