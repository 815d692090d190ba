#pragma once

#include "firmware/board_order.hpp"
#include "models/board/board_program.hpp"
#include "models/machine/ccett_machine.hpp"
#include "sim/database/board_image.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// Where the boards of a machine read the arrays of a scene that they share.
[[nodiscard]] std::uint32_t shared_database_address(const Machine& machine);

/// What board 0 of a machine is told; the others differ in their first unit.
[[nodiscard]] firmware::BoardOrder board_order(const Machine& machine,
                                               const models::FrameSetup& setup);

/// Where the program of an image begins.
[[nodiscard]] models::ProgramEntry program_entry(const BoardImage& image);

/// The routines that the host executes for it: those of the arithmetic package, where that is not
/// executed as well.
[[nodiscard]] models::HostRoutines host_routines(const Machine& machine, const BoardImage& image);

}  // namespace maquette::sim
