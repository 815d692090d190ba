#pragma once

#include <vector>

#include "sim/machine/machine.hpp"
#include "sim/run/cost_fit.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A machine on which the program of `machine` is sampled: one board with its own database, a bus
/// of 16 bits, pixels one by one. What the program takes for a pixel is the same there.
Machine sample_machine(const Machine& machine);

/// What the program of a machine's boards takes for some hundreds of pixels, spread over the useful
/// zone, and what each was counted to do. Arithmetic that the host executes in the package's place
/// is left out of what was taken. Throws DescriptionError for machines whose boards can not execute
/// their program.
std::vector<CostSample> program_samples(const Scene& scene, const Machine& machine);

}  // namespace maquette::sim
