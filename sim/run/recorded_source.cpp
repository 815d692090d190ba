#include "sim/run/recorded_source.hpp"

namespace maquette::sim {

RecordedSource::RecordedSource(const RecordedFrame& record, const Machine& machine)
    : record_(record),
      allotment_(machine.parameters.allotment, record.useful_zone,
                 static_cast<int>(machine.parameters.boards.size())) {}

const models::SynthesizedPixel& RecordedSource::pixel(std::int64_t index) {
  taken_ = record_.place_of(allotment_.position(index));
  return record_.pixels[taken_];
}

const std::vector<models::PixelLeg>& RecordedSource::legs() {
  legs_ = record_.legs.legs(taken_);
  return legs_;
}

}  // namespace maquette::sim
