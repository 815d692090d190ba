#pragma once

#include "models/machine/ccett_machine.hpp"
#include "sim/trace/bus_record.hpp"
#include "sim/trace/line_trace.hpp"

namespace maquette::sim {

/// Elaborates the video reader of a machine during a window of its frame: its signals go to the
/// trace of lines, if there is one, and the accesses that wait for it to the record, which is kept
/// by reference. Before the simulation starts.
void watch_video(models::CcettMachine& model, const TraceWindow& window, LineTrace* lines,
                 BusRecord& record);

/// Adds fields and lines to a record whose window is final, and cuts delays at its edges.
void finish_video_record(const models::CcettMachine& model, BusRecord& record);

}  // namespace maquette::sim
