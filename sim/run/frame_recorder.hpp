#pragma once

#include "firmware/arithmetic/counted.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/run/frame_source.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Whether a record tells of each pixel what its functions counted.
enum class FunctionsOfPixels { untold, told };

/// Synthesises every pixel of a scene's useful zone by the native firmware, on `threads` threads of
/// the host (at least 1), whose number changes nothing. Throws StopRequested.
RecordedFrame record_frame(const Scene& scene, const PictureFormat& format, int threads,
                           FunctionsOfPixels functions = FunctionsOfPixels::untold,
                           LegsOfPixels legs = LegsOfPixels::untold);

}  // namespace maquette::sim
