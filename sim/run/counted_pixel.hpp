#pragma once

#include "firmware/arithmetic/counted.hpp"
#include "firmware/synthesize.hpp"
#include "models/board/allotment.hpp"
#include "models/board/pixel_source.hpp"

namespace maquette::sim {

/// A pixel by the native firmware, whose work stays on this thread's meter.
inline models::SynthesizedPixel pixel_without_work(
    const firmware::Frame<firmware::Counted>& frame,
    const firmware::WorkArea<firmware::Counted>& area, const models::PixelPosition& position) {
  const firmware::Pixel pixel =
      firmware::synthesize(frame, area, static_cast<std::int16_t>(position.column),
                           static_cast<std::int16_t>(position.row));
  return {static_cast<std::uint16_t>(position.column),
          static_cast<std::uint16_t>(position.row),
          pixel.depth,
          pixel.rgb,
          pixel.rays,
          {}};
}

/// A pixel by the native firmware, which counts its work.
inline models::SynthesizedPixel counted_pixel(const firmware::Frame<firmware::Counted>& frame,
                                              const firmware::WorkArea<firmware::Counted>& area,
                                              const models::PixelPosition& position) {
  firmware::reset_counted_work();
  models::SynthesizedPixel pixel = pixel_without_work(frame, area, position);
  pixel.work = firmware::counted_work();
  return pixel;
}

/// The pixels of a frame that the firmware synthesises.
template <class Real>
models::PixelRectangle useful_zone_of(const firmware::Frame<Real>& frame) {
  const firmware::Rectangle& zone = frame.prepared.useful_zone;
  return zone.is_empty() ? models::PixelRectangle{}
                         : models::PixelRectangle{zone.first_column, zone.first_row,
                                                  zone.end_column - zone.first_column,
                                                  zone.end_row - zone.first_row};
}

}  // namespace maquette::sim
