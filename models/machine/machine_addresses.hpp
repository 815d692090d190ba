#pragma once

#include <cstddef>
#include <cstdint>

#include "models/board/pixel_writer.hpp"
#include "models/board/shared_memory.hpp"
#include "models/machine/machine_parameters.hpp"

namespace maquette::models {

/// The address map of a machine, the same on each backplane.
///
/// Each board's RAM has its own block of 256 Kbyte (VM02 data sheet p. 2-53), or of the next power
/// of two for a larger RAM, board 0 from the second block on; the frame memory follows from 8 Mbyte
/// on, or after the boards when there are too many; then, on the next block, the memory that the
/// boards share, if they share something; then the RAM of each function unit, in a block of its own
/// as a board's. Assumption: addresses may grow beyond the KVM02's 24 bits
/// (the bus has up to 32).
struct MachineAddresses {
  std::uint64_t block;  ///< of a board
  FrameWindow frame;
  SharedWindow shared;
  std::uint64_t units = 0;       ///< of function units, on from here
  std::uint64_t unit_block = 0;  ///< of each

  [[nodiscard]] std::uint64_t ram(std::size_t board) const { return block * (board + 1); }
  [[nodiscard]] std::uint64_t unit(std::size_t number) const { return units + unit_block * number; }
};

/// `shared_database_bytes` is 0 when boards have copies.
MachineAddresses machine_addresses(const MachineParameters& parameters,
                                   std::size_t shared_database_bytes);

}  // namespace maquette::models
