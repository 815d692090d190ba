#pragma once

#include <cstddef>
#include <string>

#include "sim/machine/machine.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// What a scene needs of the firmware, what was left out and what that saves, and the memory map of
/// a board that holds it.
std::string scene_report(const Scene& scene, const Machine& machine);

/// Every parameter of a scene with value, default, range and meaning.
std::string scene_parameter_report(const Scene& scene);

/// Every parameter of a machine with value, default, range, meaning and source, and its cost table.
std::string machine_report(const Machine& machine);

/// A line of headings, and one for each operation from `first` to before `end`: costs without wait
/// states, whether a call, mark and source.
std::string cost_lines(const models::ArithmeticCosts& costs, const CostTables& tables,
                       std::size_t first, std::size_t end);

}  // namespace maquette::sim
