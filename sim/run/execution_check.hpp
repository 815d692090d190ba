#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// Why the boards of a machine can not execute their program, with what to set; nothing when they
/// can. A database of so many bytes is shared, if boards share one.
[[nodiscard]] std::optional<std::string> obstacle_to_execution(
    const Machine& machine, std::size_t shared_database_bytes = 0);

/// The machine with one of its boards, for what a board does alone.
[[nodiscard]] Machine board_alone(Machine machine);

/// Throws DescriptionError, with that reason, when the boards of a machine can not execute their
/// program.
void require_execution(const Machine& machine, std::size_t shared_database_bytes = 0);

}  // namespace maquette::sim
