#pragma once

#include "models/board/allotment.hpp"
#include "models/unit/pixel_leg.hpp"
#include "sim/machine/machine.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/run/frame_source.hpp"

namespace maquette::sim {

/// Pixels of a frame that was recorded before, for any machine whose picture has its format.
class RecordedSource : public FrameSource, public models::LegSource {
 public:
  /// `record` is kept by reference.
  RecordedSource(const RecordedFrame& record, const Machine& machine);

  const models::SynthesizedPixel& pixel(std::int64_t index) override;
  [[nodiscard]] firmware::Work preprocessing() const override { return record_.preprocessing; }
  [[nodiscard]] FrameWork work_by_function() const override { return record_.by_function; }
  /// Only of a record that has legs.
  [[nodiscard]] const std::vector<models::PixelLeg>& legs() override;

 private:
  const RecordedFrame& record_;
  models::PixelAllotment allotment_;
  std::size_t taken_ = 0;  // the place of the last pixel in the record
  std::vector<models::PixelLeg> legs_;
};

}  // namespace maquette::sim
