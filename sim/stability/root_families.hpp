#pragma once

#include <string>
#include <vector>

#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// The root finder against exact roots, by families of polynomials; and its laws on polynomials
/// whose terms leave the range of the numbers, where there is nothing exact to compare with. Throws
/// DescriptionError when the table in `exact_roots_file` cannot be read.
template <class Real>
[[nodiscard]] std::vector<StabilityRow> root_rows(const std::string& exact_roots_file);

}  // namespace maquette::sim
