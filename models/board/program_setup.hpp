#pragma once

#include <cstdint>
#include <vector>

#include "models/board/board_program.hpp"

namespace maquette::models {

/// Bytes of a board's RAM, from an address of the board on.
struct RamPart {
  std::uint32_t address;
  std::vector<unsigned char> bytes;
};

/// A board's program, for boards that execute it.
struct ProgramSetup {
  ProgramEntry entry;
  HostRoutines host_routines;  ///< may be empty
  int threads = 1;             ///< of the host, for all boards together
  std::vector<std::vector<RamPart>>
      resident;  ///< by board: what its RAM holds without being loaded
};

}  // namespace maquette::models
