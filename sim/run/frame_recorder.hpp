#pragma once

#include "firmware/arithmetic/counted.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Synthesises every pixel of a scene's useful zone by the native firmware, on `threads` threads of
/// the host (at least 1), whose number changes nothing.
RecordedFrame record_frame(const Scene& scene, const PictureFormat& format, int threads);

}  // namespace maquette::sim
