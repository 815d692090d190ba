#pragma once

#include <string>
#include <vector>

#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// What was measured with one number type.
struct StabilityMeasurement {
  std::string scalar;  ///< float or double
  std::vector<StabilityRow> rows;
};

/// Rows whose bound is broken, over all measurements.
[[nodiscard]] int broken_bounds(const std::vector<StabilityMeasurement>& measurements);

/// The rows as a table for the eye, a value and its bound for each number type.
[[nodiscard]] std::string stability_table(const std::vector<StabilityMeasurement>& measurements);

/// The text of stability.json.
[[nodiscard]] std::string stability_json(const std::vector<StabilityMeasurement>& measurements);

}  // namespace maquette::sim
