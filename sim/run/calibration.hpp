#pragma once

#include <string>

#include "sim/machine/machine.hpp"
#include "sim/run/cost_fit.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// What the boards' program takes for each class of what the firmware counts, told from pixels of
/// one scene that it was executed for. Depends on the scene, the format of the picture, how the
/// machine's arithmetic is executed, and, for what none of the pixels does, its tables; neither on
/// clocks and wait states nor on the bus.
struct Calibration {
  OperationCosts costs{};    ///< without what a cost table says of arithmetic that it prices
  int pixels = 0;            ///< executed
  double sum_error = 0;      ///< of their counted clocks together, as a part
  double typical_error = 0;  ///< of the clocks of one: root of the mean square over the mean
};

/// Whether the counted work of a machine costs what executed pixels tell: its description leaves it
/// to them, and its boards can execute their program.
bool is_calibrated(const Machine& machine);

/// What calibrations are told apart by, besides the scene and the format of the picture.
std::string calibration_key(const Machine& machine);

/// Executes some hundreds of pixels, spread over the useful zone, and fits the costs to them.
/// Throws DescriptionError for machines whose boards can not execute the program.
Calibration calibrate(const Scene& scene, const Machine& machine);

/// The machine with these costs in place of its program's table and its call overhead.
Machine with_costs(const Machine& machine, const Calibration& calibration);

}  // namespace maquette::sim
