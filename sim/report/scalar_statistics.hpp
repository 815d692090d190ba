#pragma once

#include <string>
#include <vector>

#include "sim/report/statistics.hpp"

namespace maquette::sim {

/// One number or text of a run's statistics: "frame.time_s", or over a list "boards.compute_s.max".
struct ScalarStatistic {
  std::string name;
  std::string sentence;  ///< as declared
  std::string unit;      ///< as declared: "s", "pixels", "1" for a ratio, "" for a text
  std::string
      text;  ///< exact, as in stats.json; empty over an empty list and of what a run has not
};

/// Every statistic that is a single value, in the order of declaration. Of a list of groups, such
/// as the boards, each number gives its least, mean and greatest value; times have their mean to
/// the nearest picosecond. Lists of numbers and texts within lists are left out. Equal names for
/// any statistics.
[[nodiscard]] std::vector<ScalarStatistic> scalar_statistics(const Statistics& statistics);

}  // namespace maquette::sim
