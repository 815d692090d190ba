#pragma once

#include <vector>

#include "models/display/frame_memory.hpp"
#include "models/display/video_timing.hpp"

namespace maquette::models {

/// The picture on the screen at `instant`: each pixel as the frame memory held it when the video
/// reader last scanned it; the memory's background where it has not been scanned yet. That
/// needs no process: the reader's position is a closed form of time, and boards write ahead of the
/// kernel, so that the log of the writes, in the order of time, alone tells what the memory held.
Picture shown_picture(const Picture& background, const std::vector<PixelWriteRecord>& log,
                      const VideoTiming& timing, Instant instant);

/// The same of a frame memory. Throws std::logic_error when it kept no log of its writes.
Picture shown_picture(const FrameMemory& memory, const VideoTiming& timing, Instant instant);

}  // namespace maquette::models
