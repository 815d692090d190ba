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
  return {block, FrameWindow{frame_base(block, boards), memory.width, PixelFormat(memory)},
          SharedWindow{shared_base(block, boards, memory),
                       static_cast<std::int64_t>(shared_database_bytes)}};
}

}  // namespace maquette::models
