#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "sim/trace/bus_record.hpp"
#include "sim/trace/trace_format.hpp"

namespace maquette::sim {

/// The step over which the trace's utilisation is taken; steps count from the frame's start.
inline constexpr models::Duration k_utilisation_step = std::chrono::milliseconds(1);

/// Writes a record as Chrome trace JSON (Trace Event Format of the Chromium project, object form),
/// which ui.perfetto.dev and chrome://tracing open. `ts` counts microseconds from the frame's start
/// with up to six decimals, so every tick is exact.
///
/// Process 1 has one thread per board of `boards` with its states as slices. Each bus is a process
/// of its own (2, 3, ...): a thread with a slice per transfer named after the bus's master, and one
/// for each gap in which a master keeps it; the number of requests that stand, at each change; the
/// share of each k_utilisation_step (cut at the window's edges) that is spent in transfers. A flow
/// leads from each request of a board to its grant. Bus and counters are those of all boards. A
/// last process is the video reader, where it was looked at (add_video).
void write_chrome_trace(const BusRecord& record, const std::vector<std::size_t>& boards,
                        std::ostream& stream);

/// About how long write_chrome_trace's output will be.
std::int64_t expected_chrome_trace_bytes(const BusRecord& record);

/// Chrome trace JSON as a format of trace files.
inline constexpr TraceFormat k_chrome_trace{".json", write_chrome_trace,
                                            expected_chrome_trace_bytes};

}  // namespace maquette::sim
