#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/database/packed_scene.hpp"
#include "sim/machine/machine.hpp"
#include "sim/yaml/source_position.hpp"

namespace maquette::sim {

/// One use of a board's RAM.
struct MemoryUse {
  std::string name;
  std::int64_t address;
  std::int64_t bytes;
};

/// What a board's RAM holds for a scene.
struct MemoryMap {
  std::vector<MemoryUse> uses;  ///< from the bottom of RAM up, the stack at its top
  std::int64_t used_bytes = 0;
  std::int64_t ram_bytes = 0;
  std::int64_t loaded_bytes = 0;  ///< of these, what the host loads: program, database, task
  std::int64_t crossings_needed = 0;
  std::int64_t rays_needed = 0;
  std::int64_t stack_needed_bytes = 0;

  [[nodiscard]] bool fits() const { return used_bytes <= ram_bytes; }
};

/// The memory map of the boards of a machine that work at a scene. Assumption: what boards without
/// a program of their own hold is as large as what those with FFP numbers do.
MemoryMap memory_map_of(const PackedScene<float>& scene, const Machine& machine);

/// Throws DescriptionError at `position`, with the figures, when a work area is too small for the
/// scene or when the scene does not fit into RAM (the latter unless the machine allows it).
void check_memory(const MemoryMap& map, const Machine& machine, const SourcePosition& position);

}  // namespace maquette::sim
