#pragma once

#include "models/board/pixel_source.hpp"
#include "sim/machine/machine.hpp"
#include "sim/record/function_work.hpp"

namespace maquette::sim {

/// Pixels of a frame, of which is also known in which functions their work was.
class FrameSource : public models::PixelSource {
 public:
  /// Of the whole frame, when every pixel has been taken.
  [[nodiscard]] virtual FrameWork work_by_function() const = 0;
};

/// Whether a source tells the legs of its pixels: it has more to do and to keep then.
enum class LegsOfPixels { untold, told };

/// Told for machines with function units, which are handed them.
inline LegsOfPixels legs_wanted(const Machine& machine) {
  return models::has_units(machine.parameters.units) ? LegsOfPixels::told : LegsOfPixels::untold;
}

}  // namespace maquette::sim
