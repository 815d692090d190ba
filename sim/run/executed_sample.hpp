#pragma once

#include <cstdint>
#include <vector>

#include "firmware/arithmetic/work.hpp"
#include "sim/database/packed_scene.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// A pixel that a board's program has made, and what it took.
struct ExecutedPixel {
  int column;
  int row;
  std::int64_t milliclocks;   ///< of the program, with the RAM's wait states, before refresh
  firmware::Work arithmetic;  ///< that the host computed in its place
};

/// Executes the program on every `step`-th pixel of the useful zone, in rows, on a board alone.
/// Throws as set_programs.
std::vector<ExecutedPixel> executed_sample(const PackedScene<float>& packed, const Machine& machine,
                                           std::uint32_t step);

}  // namespace maquette::sim
