#pragma once

#include "models/machine/ccett_machine.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// Gives the host what it writes into each board: program, arithmetic package, database and task;
/// and what it writes where boards share a database. Throws std::out_of_range for a scene that does
/// not fit, which check_memory finds out before. Assumption: where boards have no program of their
/// own, that of FFP numbers stands for it.
void set_images(const PackedScene<float>& packed, const Machine& machine,
                models::FrameSetup& setup);

/// The same, and has the boards execute their programs on `threads` of the host. Throws
/// DescriptionError for a machine whose boards can not.
void set_programs(const PackedScene<float>& packed, const Machine& machine, int threads,
                  models::FrameSetup& setup);

}  // namespace maquette::sim
