#pragma once

#include <string>

#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// A point of a study as the verb `run` takes it.
struct StudyPoint {
  Description description;
  std::string name;  ///< of the study and the point, fit for a directory
};

/// The point with this number of a study: a file, or the name of a shipped one. Throws
/// DescriptionError.
[[nodiscard]] StudyPoint point_of_study(const std::string& study, int point);

}  // namespace maquette::sim
