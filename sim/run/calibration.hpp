#pragma once

#include "sim/machine/machine.hpp"
#include "sim/run/price_fit.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// Prices of the firmware's counts for one scene on one machine, told from pixels that the board's
/// program was executed for.
struct Calibration {
  Prices milliclocks;    ///< with the RAM's wait states and all that a call costs
  int pixels;            ///< executed
  double sum_error;      ///< of their counted time together, as a part
  double typical_error;  ///< of the time of one, as a part: root of the mean square over the mean
};

/// Executes some hundreds of pixels, spread over the useful zone, and fits the prices to them.
/// Throws DescriptionError for machines whose boards can not execute the program.
Calibration calibrate(const Scene& scene, const Machine& machine);

/// The machine with these prices in place of its cost table and its call overhead.
Machine with_prices(const Machine& machine, const Prices& milliclocks);

}  // namespace maquette::sim
