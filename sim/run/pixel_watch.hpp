#pragma once

#include "models/machine/ccett_machine.hpp"
#include "sim/maps/pixel_facts.hpp"

namespace maquette::sim {

/// Takes down from now on what each pixel of the facts' zone takes its board. The facts are kept by
/// reference. Before the simulation starts.
void watch_pixels(models::CcettMachine& model, PixelFacts& facts);

/// When each of them was written, as the log of the frame memory says, which the model keeps.
void tell_instants(const models::CcettMachine& model, PixelFacts& facts);

}  // namespace maquette::sim
