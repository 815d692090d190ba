#include "sim/command_line/study_point.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "sim/command_line/common_options.hpp"
#include "sim/scene/shipped_descriptions.hpp"
#include "sim/sweep/point_selection.hpp"
#include "sim/sweep/study_defaults.hpp"
#include "sim/sweep/study_description.hpp"
#include "sim/sweep/study_points.hpp"

namespace maquette::sim {

StudyPoint point_of_study(const std::string& study_name, int point) {
  Study study = read_study(description_file(study_name, {"studies"}, data_directory()));
  std::vector<InputFile> input_files;
  inline_files(study, data_directory(), input_files);
  complete(study);
  const StudyPoints points(std::move(study), data_directory());
  const int chosen = parse_points(std::to_string(point), "--point", points.size()).front();
  StudyPoint result{points.description(chosen),
                    fmt::format("{}-point{}", points.study().name, chosen)};
  result.description.input_files = std::move(input_files);
  return result;
}

}  // namespace maquette::sim
