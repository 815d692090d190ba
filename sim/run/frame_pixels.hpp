#pragma once

#include <memory>

#include "models/board/allotment.hpp"
#include "models/unit/pixel_leg.hpp"
#include "sim/machine/machine.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/run/frame_source.hpp"
#include "sim/run/scene_warnings.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Where the pixels of a run come from.
struct FramePixels {
  std::unique_ptr<RecordedFrame> record;  ///< made for this run, if it was
  std::unique_ptr<FrameSource> source;
  models::LegSource* legs = nullptr;  ///< the source's, where they are told
  models::PixelRectangle zone;        ///< the useful one
};

/// Those of a record, which is kept by reference, or of the firmware when it is null: as it goes,
/// or where boards may compute too long the whole frame before the run, for then it is known. What
/// boards that execute their program compute is not, `executed`. A record of which legs are wanted
/// has them. `warn`, where it is given, is told what the frame and its likely time say; of a record
/// only the time. Throws as require_computing_time.
FramePixels frame_pixels(const Scene& scene, const Machine& machine, const RecordedFrame* record,
                         bool executed, int threads, LegsOfPixels legs = LegsOfPixels::untold,
                         const Warn& warn = {});

}  // namespace maquette::sim
