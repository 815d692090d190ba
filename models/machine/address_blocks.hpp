#pragma once

#include <algorithm>
#include <cstdint>

#include "models/board/long_word.hpp"
#include "models/machine/machine_parameters.hpp"

/// How the addresses of the bus are shared out; machine_addresses.hpp says what stands where.
namespace maquette::models {

inline constexpr std::uint64_t k_least_block = 0x40000;
inline constexpr std::uint64_t k_least_frame_base = 0x800000;

/// The bytes of addresses that a pixel of the frame memory takes.
inline constexpr std::uint64_t k_pixel_address_bytes = 4;

/// The end of the addresses of a VERSAbus, which has up to 32 address lines.
inline constexpr std::uint64_t k_end_of_addresses = std::uint64_t{1} << 32U;

/// The block of a board's RAM: the least power of two that holds it.
inline std::uint64_t block_of(std::int64_t ram_bytes) {
  std::uint64_t block = k_least_block;
  while (block < static_cast<std::uint64_t>(ram_bytes)) {
    block *= 2;
  }
  return block;
}

/// Where the frame memory begins, with such blocks.
inline std::uint64_t frame_base(std::uint64_t block, std::size_t boards) {
  return std::max(k_least_frame_base, block * (boards + 1));
}

/// Where the memory that boards share begins, on the next block behind the frame memory.
inline std::uint64_t shared_base(std::uint64_t block, std::size_t boards,
                                 const FrameMemoryParameters& frame) {
  const std::uint64_t frame_end =
      frame_base(block, boards) + static_cast<std::uint64_t>(frame.width) *
                                      static_cast<std::uint64_t>(frame.height) *
                                      k_pixel_address_bytes;
  return (frame_end + block - 1) / block * block;
}

/// The block of a function unit's RAM, with its mailbox.
inline std::uint64_t unit_block(const UnitsParameters& units) {
  std::uint64_t block = 0;
  for (const FunctionUnitParameters& kind : units.kinds) {
    if (kind.number > 0) {
      block = std::max(block, block_of(kind.ram_bytes + static_cast<std::int64_t>(k_long_bytes)));
    }
  }
  return block;
}

/// Where function units begin, on the next of their blocks behind all else.
inline std::uint64_t units_base(std::uint64_t end, std::uint64_t block) {
  return (end + block - 1) / block * block;
}

}  // namespace maquette::models
