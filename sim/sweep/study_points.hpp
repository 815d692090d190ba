#pragma once

#include <string>
#include <vector>

#include "sim/scene/description_loader.hpp"
#include "sim/sweep/own_values.hpp"
#include "sim/sweep/point_list.hpp"
#include "sim/sweep/study.hpp"

namespace maquette::sim {

/// A varied parameter of a point, as tables and plots show it.
struct PointParameter {
  std::string path;
  std::string value;
};

/// A study with its points and their descriptions. The study must need no other file
/// (inline_files).
class StudyPoints {
 public:
  /// Throws DescriptionError when the study's own description is wrong.
  StudyPoints(Study study, std::string data_directory);

  [[nodiscard]] const Study& study() const { return study_; }
  [[nodiscard]] int size() const { return points_.size(); }

  /// The description of a point, checked. Throws DescriptionError.
  [[nodiscard]] Description description(int point) const;

  /// The value of each axis, the description's own one where the point leaves it alone; in the
  /// order of the axes.
  [[nodiscard]] std::vector<PointParameter> parameters(int point) const;

  /// What the parameter of an axis is, for people; "" when it is not declared.
  [[nodiscard]] std::string sentence(std::size_t axis) const;

  /// Whether the machine of a description is the prototype as documented, whatever its name.
  [[nodiscard]] bool is_prototype(const Description& description) const;

 private:
  Study study_;
  std::string data_;
  OwnValues own_;
  PointList points_;
  std::string prototype_;
};

}  // namespace maquette::sim
