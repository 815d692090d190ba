#pragma once

#include <optional>

#include "models/machine/machine_statistics.hpp"
#include "sim/machine/machine.hpp"
#include "sim/record/function_work.hpp"
#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// What boards did by function and kind of ray: the time that they worked in the mean, in
/// proportion to the price of the work. The whole frame must have been computed.
FunctionStatistics function_statistics(const models::MachineStatistics& model,
                                       const Machine& machine, const FrameWork& work);

ExtentStatistics extent_statistics(const FrameWork& work);

/// Nothing where no intersection has a root that needs refining.
std::optional<IntersectionRoots> intersection_roots(const FrameWork& work);

}  // namespace maquette::sim
