#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/report/statistics.hpp"
#include "sim/sweep/study_points.hpp"

namespace maquette::sim {

/// What came of a point: statistics, or the reason why there are none.
struct PointResult {
  std::optional<Statistics> statistics;
  std::string failure;
};

/// The text of a point's file. `study` is the digest of what the point belongs to.
[[nodiscard]] std::string point_json(int point, const std::vector<PointParameter>& parameters,
                                     const std::string& study, const PointResult& result);

/// A point's file as it was read.
struct PointFile {
  std::string study;
  PointResult result;
};

/// Reads what point_json has written; `name` is that of the file. Throws DescriptionError.
[[nodiscard]] PointFile parse_point(const std::string& json, const std::string& name);

}  // namespace maquette::sim
