#include "sim/sweep/study_defaults.hpp"

#include <algorithm>

#include "sim/sweep/point_list.hpp"

namespace maquette::sim {

namespace {

constexpr const char* k_processors = "processors";
constexpr const char* k_frame_time = "frame.time_s";

}  // namespace

void complete(Study& study) {
  if (study.name.empty()) {
    const YamlNode* name = study.scene.find("name");
    study.name = (name == nullptr ? "study" : name->text) + "-sweep";
  }
  const bool varies_boards =
      std::any_of(study.axes.begin(), study.axes.end(),
                  [](const Axis& axis) { return axis.path == k_processors; });
  if (varies_boards && study.columns.empty() && plain_point(study.design) < 0) {
    study.columns = {{"speed_up",
                      "",
                      "against the first number of boards",
                      Derivation::speed_up,
                      k_frame_time,
                      k_processors,
                      {}},
                     {"efficiency",
                      "",
                      "speed-up over the ratio of the numbers of boards",
                      Derivation::efficiency,
                      k_frame_time,
                      k_processors,
                      {}}};
  }
}

}  // namespace maquette::sim
