#pragma once

#include <vector>

#include "models/board/allotment.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// One in `step` of the units in which a machine's boards take their pixels, the first one among
/// them; of bands the rows are the units, of an interlace the pixels.
struct PixelSample {
  models::AllotmentParameters allotment;
  int step;
};

/// A sample of about one in `share` (at least 1): `step` is the first number from there on that has
/// no divisor in common with the units of a row, so that the sample is spread over the columns of
/// the zone as over its rows.
[[nodiscard]] PixelSample pixel_sample(const Machine& machine, const models::PixelRectangle& zone,
                                       int share);

/// The pixels of a sample, unit by unit.
[[nodiscard]] std::vector<models::PixelPosition> pixels_of(const PixelSample& sample,
                                                           const models::PixelRectangle& zone);

}  // namespace maquette::sim
