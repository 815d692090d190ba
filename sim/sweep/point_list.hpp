#pragma once

#include <cstddef>
#include <vector>

#include "sim/sweep/own_values.hpp"
#include "sim/sweep/study.hpp"

namespace maquette::sim {

/// The points of a study, numbered from 0 in an order that only the study decides.
class PointList {
 public:
  /// Throws DescriptionError when the axes do not fit the design, or the points are more than
  /// k_most_values.
  PointList(const Study& study, const OwnValues& own);

  [[nodiscard]] int size() const { return size_; }

  /// The value of each axis; null where the point leaves it alone. Valid as long as the list.
  [[nodiscard]] std::vector<const AxisValue*> values(int point) const;

 private:
  StudyDesign design_;
  std::vector<std::vector<AxisValue>> values_;  ///< of each axis
  int size_ = 0;
};

/// The design's point that varies nothing; -1 when it has none.
[[nodiscard]] constexpr int plain_point(StudyDesign design) {
  switch (design) {
    case StudyDesign::grid:
    case StudyDesign::zip:
      return -1;
    case StudyDesign::one_at_a_time:
    case StudyDesign::latin_hypercube:
      break;
  }
  return 0;
}

}  // namespace maquette::sim
