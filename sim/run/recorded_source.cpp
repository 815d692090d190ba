#include "sim/run/recorded_source.hpp"

#include <cstddef>

namespace maquette::sim {

namespace {

/// So many pixels are simulated while one comes from memory.
constexpr std::int64_t k_pixels_ahead = 16;

void prefetch(const models::SynthesizedPixel& pixel) {
  constexpr std::size_t k_line_bytes = 64;
  const auto* const bytes = reinterpret_cast<const char*>(&pixel);
  for (std::size_t byte = 0; byte < sizeof pixel; byte += k_line_bytes) {
    __builtin_prefetch(bytes + byte);
  }
}

}  // namespace

RecordedSource::RecordedSource(const RecordedFrame& record, const Machine& machine)
    : record_(record),
      allotment_(machine.parameters.allotment, record.useful_zone,
                 static_cast<int>(machine.parameters.boards.size())) {}

const models::SynthesizedPixel& RecordedSource::pixel(std::int64_t index) {
  // A frame is larger than caches, and boards come to its pixels one after the other.
  if (const std::int64_t later = index + k_pixels_ahead; later < allotment_.pixels()) {
    prefetch(record_.at(allotment_.position(later)));
  }
  taken_ = record_.place_of(allotment_.position(index));
  return record_.pixels[taken_];
}

const std::vector<models::PixelLeg>& RecordedSource::legs() {
  legs_ = record_.legs.legs(taken_);
  return legs_;
}

}  // namespace maquette::sim
