#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim/scene/description_loader.hpp"
#include "sim/sweep/axis.hpp"
#include "sim/sweep/derived_column.hpp"
#include "sim/sweep/plot.hpp"

namespace maquette::sim {

/// How the points of a study come from its axes.
enum class StudyDesign {
  grid,            ///< every combination; the first axis varies slowest
  zip,             ///< the first values of all axes, the second ones, ...
  one_at_a_time,   ///< point 0 varies nothing, each other one a single axis
  latin_hypercube  ///< point 0 varies nothing; the others stratify every axis evenly
};

/// Whether each point but the plain one varies a single axis.
constexpr bool varies_single_axes(StudyDesign design) {
  switch (design) {
    case StudyDesign::grid:
    case StudyDesign::zip:
    case StudyDesign::latin_hypercube:
      return false;
    case StudyDesign::one_at_a_time:
      break;
  }
  return true;
}

/// Whether axes are sampled, instead of having all of their values taken.
constexpr bool is_sampled(StudyDesign design) {
  switch (design) {
    case StudyDesign::grid:
    case StudyDesign::zip:
    case StudyDesign::one_at_a_time:
      return false;
    case StudyDesign::latin_hypercube:
      break;
  }
  return true;
}

/// What a sweep varies around which description, and what is to be drawn of it.
struct Study {
  std::string name;
  std::string sentence;             ///< what the study asks, for people
  YamlNode scene;                   ///< a file's name, or inline
  std::optional<YamlNode> machine;  ///< the same; else the scene's own
  std::vector<Override> changes;
  std::vector<Axis> axes;
  StudyDesign design = StudyDesign::grid;
  int samples = 100;      ///< of the Latin hypercube
  std::int64_t seed = 1;  ///< of the Latin hypercube
  std::vector<DerivedColumn> columns;
  std::vector<Plot> plots;
};

}  // namespace maquette::sim
