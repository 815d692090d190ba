#pragma once

#include <cstdint>
#include <ctime>

#include "models/display/picture.hpp"
#include "sim/database/prepared_scene.hpp"

namespace maquette::sim {

/// A frame synthesised without timing and without SystemC.
struct SynthesizedFrame {
  models::Picture picture;
  std::int64_t rays = 0;
  double time_s = 0;  ///< processor time of the synthesis alone
};

/// Synthesises every pixel of the useful zone on this thread.
template <class Real>
SynthesizedFrame synthesized_frame(const PreparedScene<Real>& scene) {
  const firmware::Frame<Real>& frame = scene.frame();
  const firmware::Rectangle& zone = frame.prepared.useful_zone;
  const firmware::Observer<Real>& observer = frame.database.observer;
  SynthesisArea<Real> area(frame.database);
  const firmware::WorkArea<Real> work_area = area.view();
  SynthesizedFrame result;
  result.picture = {observer.columns, observer.rows,
                    std::vector<std::uint32_t>(static_cast<std::size_t>(observer.columns) *
                                                   static_cast<std::size_t>(observer.rows),
                                               firmware::rgb_of(frame.database.background))};
  const std::clock_t start = std::clock();
  for (std::int16_t row = zone.first_row; row < zone.end_row; ++row) {
    std::uint32_t* const pixels =
        result.picture.pixels.data() +
        static_cast<std::size_t>(row) * static_cast<std::size_t>(observer.columns);
    for (std::int16_t column = zone.first_column; column < zone.end_column; ++column) {
      const firmware::Pixel pixel = firmware::synthesize(frame, work_area, column, row);
      pixels[column] = pixel.rgb;
      result.rays +=
          pixel.rays.primary + pixel.rays.reflected + pixel.rays.refracted + pixel.rays.shadow;
    }
  }
  result.time_s = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
  return result;
}

}  // namespace maquette::sim
