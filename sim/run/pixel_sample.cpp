#include "sim/run/pixel_sample.hpp"

#include <numeric>

namespace maquette::sim {

namespace {

int units_per_row(const models::AllotmentParameters& allotment, int zone_width) {
  switch (allotment.order) {
    case models::Allotment::interleaved_pixels:
      return zone_width;
    case models::Allotment::tiles:
      return (zone_width + allotment.tile_width - 1) / allotment.tile_width;
    case models::Allotment::interleaved_lines:
    case models::Allotment::bands:
    case models::Allotment::interlaced:
      break;
  }
  return 1;
}

}  // namespace

PixelSample pixel_sample(const Machine& machine, const models::PixelRectangle& zone, int share) {
  PixelSample sample{machine.parameters.allotment, share};
  sample.allotment.assignment = models::Assignment::fixed;
  if (sample.allotment.order == models::Allotment::bands) {
    sample.allotment.order = models::Allotment::interleaved_lines;
  } else if (sample.allotment.order == models::Allotment::interlaced) {
    sample.allotment.order = models::Allotment::interleaved_pixels;
  }
  const int units = units_per_row(sample.allotment, zone.width);
  while (sample.step > 1 && std::gcd(sample.step, units) > 1) {
    ++sample.step;
  }
  return sample;
}

std::vector<models::PixelPosition> pixels_of(const PixelSample& sample,
                                             const models::PixelRectangle& zone) {
  const models::PixelAllotment allotment(sample.allotment, zone, 1);
  std::vector<models::PixelPosition> pixels;
  for (std::int64_t unit = 0; unit < allotment.units(); unit += sample.step) {
    const std::int64_t end = allotment.first_pixel(unit + 1);
    for (std::int64_t index = allotment.first_pixel(unit); index < end; ++index) {
      pixels.push_back(allotment.position(index));
    }
  }
  return pixels;
}

}  // namespace maquette::sim
