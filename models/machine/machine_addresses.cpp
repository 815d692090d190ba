#include "models/machine/machine_addresses.hpp"

#include "models/display/frame_memory.hpp"
#include "models/machine/address_blocks.hpp"

namespace maquette::models {

static_assert(FrameMemory::k_pixel_bytes == k_pixel_address_bytes);

MachineAddresses machine_addresses(const MachineParameters& parameters,
                                   std::size_t shared_database_bytes) {
  const std::size_t boards = parameters.boards.size();
  const std::uint64_t block = block_of(parameters.board.ram_bytes);
  const FrameMemoryParameters& memory = parameters.frame_memory;
  MachineAddresses addresses{
      block, FrameWindow{frame_base(block, boards), memory.width, PixelFormat(memory)},
      SharedWindow{shared_base(block, boards, memory),
                   static_cast<std::int64_t>(shared_database_bytes)}};
  if (has_units(parameters.units)) {
    addresses.unit_block = unit_block(parameters.units);
    addresses.units = units_base(shared_base(block, boards, memory) + block, addresses.unit_block);
  }
  return addresses;
}

}  // namespace maquette::models
