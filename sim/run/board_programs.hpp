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

/// Leaves out what the boards and function units hold already from the images of another scene, set
/// up for the same machine: of a scene's images only the words that differ are loaded. Programs
/// that are executed find the rest in their RAM.
void load_changes(const models::FrameSetup& before, const Machine& machine,
                  models::FrameSetup& setup);

/// The same, and has the boards execute their programs on `threads` of the host. Throws
/// DescriptionError for a machine whose boards can not.
void set_programs(const PackedScene<float>& packed, const Machine& machine, int threads,
                  models::FrameSetup& setup);

}  // namespace maquette::sim
