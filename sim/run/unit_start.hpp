#pragma once

#include "models/machine/ccett_machine.hpp"
#include "sim/database/memory_map.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// Gives the host what it writes into each function unit, and boards where they take what comes
/// back; nothing for a machine without units. Throws DescriptionError, at the scene's object, for a
/// database that a unit has no room for, unless the machine allows it.
void set_units(const Scene& scene, const PackedScene<float>& packed, const MemoryMap& map,
               Machine& machine, models::FrameSetup& setup);

}  // namespace maquette::sim
