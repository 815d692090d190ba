#pragma once

#include <cstdint>
#include <optional>

#include "models/board/allotment_parameters.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// What a board's RAM has room for besides the program and the scene.
struct BoardRoom {
  std::uint32_t ram_bytes;
  std::uint32_t system_bytes;  ///< at the bottom
  std::uint32_t crossings;
  std::uint32_t waiting_rays;
  std::uint32_t line_pixels;      ///< that are kept until they are written together
  std::uint32_t own_pixel_bytes;  ///< of the screen, which the board keeps
  std::uint32_t stack_bytes;      ///< at the top
  /// Of the arithmetic package, where it is larger than the program's.
  std::uint32_t package_bytes;
  /// Where the arrays of the scene are when they are in shared memory instead.
  std::optional<std::uint32_t> shared_database = {};
  models::Allotment order = {};        ///< of the pixels, which has its program
  std::uint32_t pixels_in_flight = 0;  ///< of boards that hand out errands; else 0
};

/// The room in the boards of a machine; `shared_database` matters only when they share one.
[[nodiscard]] BoardRoom board_room(const Machine& machine, std::uint32_t shared_database = 0);

}  // namespace maquette::sim
