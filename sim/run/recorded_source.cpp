#include "sim/run/recorded_source.hpp"

namespace maquette::sim {

RecordedSource::RecordedSource(const RecordedFrame& record, const Machine& machine)
    : record_(record),
      allotment_(machine.parameters.allotment, record.useful_zone,
                 static_cast<int>(machine.parameters.boards.size())) {}

const models::SynthesizedPixel& RecordedSource::pixel(std::int64_t index) {
  return record_.at(allotment_.position(index));
}

}  // namespace maquette::sim
