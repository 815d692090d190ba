#pragma once

#include "models/machine/ccett_machine.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// Gives a frame's boards their programs: code, arithmetic package and database as the host loads
/// them, and what else of their RAM is to be set. `threads` of the host execute them. Throws
/// DescriptionError for a machine whose boards can not execute the firmware's program, and for a
/// scene that does not fit.
void set_programs(const PackedScene<float>& packed, const Machine& machine, int threads,
                  models::FrameSetup& setup);

}  // namespace maquette::sim
