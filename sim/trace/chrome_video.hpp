#pragma once

#include "sim/trace/chrome_events.hpp"
#include "sim/trace/video_record.hpp"

namespace maquette::sim {

/// Adds a process with three threads: the fields, the lines with the rows that they show, and the
/// accesses to the frame memory that wait for the reader.
void add_video(const VideoRecord& record, int process, ChromeEvents& events);

}  // namespace maquette::sim
