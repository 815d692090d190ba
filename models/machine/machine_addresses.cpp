#include "models/machine/machine_addresses.hpp"

#include <algorithm>

#include "models/display/frame_memory.hpp"

namespace maquette::models {

namespace {

constexpr std::uint64_t k_least_block = 0x40000;
constexpr std::uint64_t k_least_frame_base = 0x800000;

std::uint64_t ram_block(const Kvm02Parameters& board) {
  std::uint64_t block = k_least_block;
  while (block < static_cast<std::uint64_t>(board.ram_bytes)) {
    block *= 2;
  }
  return block;
}

std::uint64_t frame_bytes(const FrameMemoryParameters& frame) {
  return static_cast<std::uint64_t>(frame.width) * static_cast<std::uint64_t>(frame.height) *
         FrameMemory::k_pixel_bytes;
}

}  // namespace

MachineAddresses machine_addresses(const MachineParameters& parameters,
                                   std::size_t shared_database_bytes) {
  const std::uint64_t block = ram_block(parameters.board);
  const std::uint64_t boards_end = block * (parameters.boards.size() + 1);
  const FrameWindow frame{std::max(k_least_frame_base, boards_end), parameters.frame_memory.width,
                          PixelFormat(parameters.frame_memory)};
  const std::uint64_t frame_end = frame.base + frame_bytes(parameters.frame_memory);
  return {block, frame,
          SharedWindow{(frame_end + block - 1) / block * block,
                       static_cast<std::int64_t>(shared_database_bytes)}};
}

}  // namespace maquette::models
