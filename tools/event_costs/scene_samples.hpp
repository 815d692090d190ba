#pragma once

#include <string>
#include <vector>

#include "sim/run/cost_fit.hpp"

namespace maquette::costs {

/// The class that stands for every call of the arithmetic package in these samples.
inline constexpr auto k_call = firmware::Operation::add;

/// What the prototype's program took for pixels of all shipped scenes and of a large union, besides
/// arithmetic, in a small frame: the events of each and its calls of the package, counted as
/// k_call. Scenes weigh alike, whatever their pixels take.
std::vector<sim::CostSample> samples_of_all_scenes(const std::string& data_directory);

}  // namespace maquette::costs
