#include "sim/run/recorded_source.hpp"

namespace maquette::sim {

RecordedSource::RecordedSource(const RecordedFrame& record, const Machine& machine)
    : record_(record),
      allotment_(machine.parameters.allotment, record.useful_zone,
                 static_cast<int>(machine.parameters.boards.size())) {}

const models::SynthesizedPixel& RecordedSource::pixel(std::int64_t index) {
  const models::PixelPosition position = allotment_.position(index);
  const models::PixelRectangle& zone = record_.useful_zone;
  const auto row = static_cast<std::size_t>(position.row - zone.row0);
  const auto column = static_cast<std::size_t>(position.column - zone.column0);
  return record_.pixels[row * static_cast<std::size_t>(zone.width) + column];
}

}  // namespace maquette::sim
