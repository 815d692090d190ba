#pragma once

#include "models/display/frame_memory.hpp"
#include "models/display/video_timing.hpp"

namespace maquette::models {

/// The picture on the screen at `instant`: each pixel as the frame memory held it when the video
/// reader last scanned it; the memory's background where it has not been scanned yet. The reader
/// needs no process, since its position is a closed form of time. Throws std::logic_error when the
/// memory kept no log of its writes.
Picture shown_picture(const FrameMemory& memory, const VideoTiming& timing, Instant instant);

}  // namespace maquette::models
