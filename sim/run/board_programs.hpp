#pragma once

#include "models/machine/ccett_machine.hpp"
#include "sim/database/board_image.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// What the boards of a machine have room for.
BoardRoom board_room(const Machine& machine);

/// Whether boards that execute their program execute its arithmetic package as well. Throws
/// DescriptionError when they can not execute it with the machine's arithmetic.
bool executes_package(const Machine& machine);

/// Gives a frame's boards their programs: code, arithmetic package and database as the host loads
/// them, and what else of their RAM is to be set. `threads` of the host execute them. Throws
/// DescriptionError for a machine whose boards can not execute the firmware's program, and for a
/// scene that does not fit.
void set_programs(const PackedScene<float>& packed, const Machine& machine, int threads,
                  models::FrameSetup& setup);

}  // namespace maquette::sim
