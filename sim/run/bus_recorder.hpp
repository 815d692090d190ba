#pragma once

#include <cstddef>
#include <string>

#include "models/machine/ccett_machine.hpp"
#include "sim/trace/bus_record.hpp"

namespace maquette::sim {

/// A backplane's name in traces.
[[nodiscard]] std::string backplane_name(std::size_t backplane);

/// Records from now on what happens on the bus of a machine during a window of its frame. `model`
/// and `record` are kept by reference.
void start_record(models::CcettMachine& model, const TraceWindow& window, BusRecord& record);

/// Completes a record when the run has ended: the end of the frame, the boards' last instants.
void finish_record(const models::CcettMachine& model, BusRecord& record);

}  // namespace maquette::sim
