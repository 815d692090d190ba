#pragma once

#include "sim/trace/vcd_changes.hpp"
#include "sim/trace/vcd_dump.hpp"
#include "sim/trace/video_record.hpp"

namespace maquette::sim {

/// Adds a scope of the video reader: field (1 or 2), line, row, which floats on lines that show
/// none, and WAIT_n (an access to the frame memory waits for a slot). Keeps both by reference.
std::vector<ChangeSource> dump_video(const VideoRecord& record, VcdDump& dump);

}  // namespace maquette::sim
