#pragma once

#include <vector>

#include "sim/report/table.hpp"
#include "sim/sweep/axis.hpp"
#include "sim/sweep/derived_column.hpp"

namespace maquette::sim {

/// Appends a derived column; its cells are empty where a value that it needs is missing or zero.
/// `axes` are the varied parameters, which tell the series apart.
void add_derived_column(Table& table, const DerivedColumn& column, const std::vector<Axis>& axes);

}  // namespace maquette::sim
