#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firmware/database.hpp"
#include "sim/machine/machine.hpp"
#include "sim/yaml/source_position.hpp"

namespace maquette::sim {

/// One use of a board's RAM.
struct MemoryUse {
  std::string name;
  std::int64_t bytes;
};

/// What a board's RAM holds for a scene.
struct MemoryMap {
  std::vector<MemoryUse> uses;  ///< from the bottom of RAM up
  std::int64_t used_bytes = 0;
  std::int64_t ram_bytes = 0;
  std::int64_t loaded_bytes = 0;    ///< of these, what the host loads: code and database
  std::int64_t database_bytes = 0;  ///< of these; none of a shared database
  std::int64_t left_out_bytes = 0;  ///< of code that the scene does not need
  std::int64_t crossings_needed = 0;
  std::int64_t rays_needed = 0;
  std::int64_t stack_needed_bytes = 0;

  [[nodiscard]] bool fits() const { return used_bytes <= ram_bytes; }
};

/// Lays out a board's RAM.
template <class Real>
MemoryMap memory_map_of(const firmware::Database<Real>& database, int tree_height,
                        const Machine& machine);

/// Throws DescriptionError at `position`, with the figures, when a work area is too small for the
/// scene or when the scene does not fit into RAM (the latter unless the machine allows it).
void check_memory(const MemoryMap& map, const Machine& machine, const SourcePosition& position);

}  // namespace maquette::sim
