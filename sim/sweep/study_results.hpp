#pragma once

#include "sim/sweep/study_directory.hpp"
#include "sim/sweep/study_table.hpp"

namespace maquette::sim {

/// How many points of a study have which end.
struct StudyOutcome {
  int done = 0;
  int failed = 0;
  int missing = 0;
  Table table;  ///< of all points
};

/// Gathers what is stored of every point into table.csv and the plots, the same bytes however the
/// points were run. Throws DescriptionError for a damaged point and for plots that can not be made.
StudyOutcome gather(const StudyPoints& points, const StudyDirectory& directory);

/// The outcome as a text for the eye; names points that failed or are missing.
[[nodiscard]] std::string outcome_report(const StudyOutcome& outcome);

}  // namespace maquette::sim
