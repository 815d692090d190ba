#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "sim/trace/bus_record.hpp"
#include "sim/trace/trace_format.hpp"

namespace maquette::sim {

/// Writes a record as a chart for a slide (SVG 1.1; browsers and office programs open it): a track
/// for each board of `boards`, the owner of each bus, and its queue of requests. Of a window with
/// more to see than the picture has columns, a column shows the shares of its time.
void write_svg_trace(const BusRecord& record, const std::vector<std::size_t>& boards,
                     std::ostream& stream);

/// About how long write_svg_trace's output will be.
std::int64_t expected_svg_trace_bytes(const BusRecord& record);

/// Charts as a format of trace files.
inline constexpr TraceFormat k_svg_trace{".svg", write_svg_trace, expected_svg_trace_bytes};

}  // namespace maquette::sim
