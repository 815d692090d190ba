#pragma once

#include <cstdint>
#include <functional>

#include "models/board/allotment.hpp"
#include "models/board/arithmetic_costs.hpp"
#include "models/bus/duration.hpp"
#include "sim/machine/machine.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A pixel as a board's program writes it.
struct ExecutedPixel {
  models::PixelPosition position;
  std::uint32_t bytes;            ///< as models::PixelFormat
  models::Duration time;          ///< that its board computed since the last one
  models::OperationCost program;  ///< of the same, without wait states and what the host executed
};

/// Called with each pixel; false ends the execution.
using PixelTaker = std::function<bool(const ExecutedPixel& pixel)>;

/// Executes the program of a machine's boards on one of them alone, without a bus, for a sample of
/// one in about `share` of the pixels (pixel_sample), each written by itself. Throws
/// DescriptionError when boards can not execute it, and std::logic_error when it goes wrong.
void execute_pixels(const Scene& scene, const Machine& machine, int share, const PixelTaker& take);

}  // namespace maquette::sim
