#pragma once

#include <optional>
#include <vector>

#include "sim/report/table.hpp"
#include "sim/sweep/point_result.hpp"
#include "sim/sweep/study_points.hpp"

namespace maquette::sim {

/// What is stored of each point; nothing for those that have not been run.
using PointResults = std::vector<std::optional<PointResult>>;

/// The table of a study: number of the point, varied parameters, status (done, failed, missing)
/// and its reason, every scalar statistic, derived columns. A parameter whose values are all
/// numbers has their unit in its heading and plain numbers in its cells.
[[nodiscard]] Table study_table(const StudyPoints& points, const PointResults& results);

/// Throws DescriptionError when a derived column or a plot names a column that is not
/// there.
void check_columns(const StudyPoints& points);

}  // namespace maquette::sim
