#pragma once

#include "sim/machine/machine.hpp"
#include "sim/maps/pixel_facts.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// The facts of pixels that the firmware tells when it synthesises them once more, on `threads`
/// threads of the host, whose number changes nothing; of a record what it holds is taken from
/// there. The machine's costs are those at which work is priced; what its boards computed is in the
/// facts already. Throws StopRequested.
void synthesise_facts(const Scene& scene, const Machine& machine, const RecordedFrame* record,
                      const WantedFacts& wanted, int threads, PixelFacts& facts);

}  // namespace maquette::sim
