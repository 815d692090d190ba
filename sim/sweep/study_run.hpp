#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/sweep/study_directory.hpp"
#include "sim/sweep/study_points.hpp"

namespace maquette::sim {

/// Checks the description of every point, also whether the machine can hold its scene. Gives the
/// name of the record that each point can replay. Throws the DescriptionError of the first that is
/// wrong.
[[nodiscard]] std::vector<std::string> check_points(const StudyPoints& points);

/// How far a run of points has come.
struct StudyProgress {
  int done = 0;
  int failed = 0;   ///< of those
  int planned = 0;  ///< by this run
};

/// Simulates the points `numbers` in `processes` processes at a time, each point in its own, and
/// stores what comes of each as soon as it is there. Points that share a record (`records`, of
/// every point of the study) replay it: the scene is synthesised once for all of them. A point that
/// throws or crashes is stored as failed. `show` is called after each point. Stops early when an
/// interruption is requested; what was being simulated then is not stored.
StudyProgress run_points(const StudyPoints& points, const StudyDirectory& directory,
                         const std::vector<std::string>& records, const std::vector<int>& numbers,
                         int processes, const std::function<void(const StudyProgress&)>& show);

}  // namespace maquette::sim
