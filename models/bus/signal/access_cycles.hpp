#pragma once

#include "models/bus/address_map.hpp"
#include "models/bus/burst_progress.hpp"
#include "models/bus/bus_slaves.hpp"
#include "models/bus/signal/bus_cycle.hpp"

namespace maquette::models {

/// Does the access of a burst that is next, over the lines, in its master's process: a transfer, or
/// a test-and-set cycle, which reads, lets the processor change the first byte, and writes with the
/// address strobe still low (MC68000 TAS); the burst keeps what was read. The lines do not say
/// which bus error there was; the map tells an address without a slave.
AccessResult do_access(BurstProgress& burst, const AddressMap& map, BusCycle& cycle);

}  // namespace maquette::models
