#pragma once

#include "models/board/allotment.hpp"
#include "sim/machine/machine.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/run/frame_source.hpp"

namespace maquette::sim {

/// Pixels of a frame that was recorded before, for any machine whose picture has its format.
class RecordedSource : public FrameSource {
 public:
  /// `record` is kept by reference.
  RecordedSource(const RecordedFrame& record, const Machine& machine);

  const models::SynthesizedPixel& pixel(std::int64_t index) override;
  [[nodiscard]] firmware::Work preprocessing() const override { return record_.preprocessing; }
  [[nodiscard]] FrameWork work_by_function() const override { return record_.by_function; }

 private:
  const RecordedFrame& record_;
  models::PixelAllotment allotment_;
};

}  // namespace maquette::sim
