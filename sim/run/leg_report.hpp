#pragma once

#include <string>

#include "sim/machine/machine.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// How the process of a scene's pixels comes apart into legs, as a table: for each stage, and each
/// primitive that rays are intersected with, legs of a pixel in the mean, what one is handed and
/// returns, what it takes at the costs of the machine, and its share of all of it. Synthesises the
/// frame on `threads` threads of the host.
std::string leg_report(const Scene& scene, const Machine& machine, int threads);

}  // namespace maquette::sim
