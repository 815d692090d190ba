#pragma once

#include <vector>

#include "sim/stability/sample_solids.hpp"

namespace maquette::sim {

/// An operator over objects.
[[nodiscard]] Object combined(firmware::BooleanOperator combination, std::vector<Object> children);

/// Solids of all families around a place, within about `spread` of it, of the trial surfaces,
/// combined at random two by two.
[[nodiscard]] Object random_tree(trial::Random& random, const std::vector<SolidFamily>& families,
                                 int solids, const Vector3& center, double spread);

}  // namespace maquette::sim
