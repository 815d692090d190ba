#pragma once

#include "models/machine/ccett_machine.hpp"
#include "sim/trace/line_trace.hpp"

namespace maquette::sim {

/// Has a trace show the lines of a machine's backplanes during its frame. To be called before the
/// machine runs; `model` and `trace` are kept by reference.
void record_lines(models::CcettMachine& model, LineTrace& trace);

}  // namespace maquette::sim
