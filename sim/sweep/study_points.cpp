#include "sim/sweep/study_points.hpp"

#include <utility>

#include "sim/machine/machine_description.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {
namespace {

bool is_whole_scene(const Axis& axis) { return axis.path == "scene"; }
bool is_whole_machine(const Axis& axis) { return axis.path == "machine"; }

/// The description of a point that gives each axis this value. Whole scenes and machines come
/// before what the study sets in them.
Description describe(const Study& study, const std::vector<const AxisValue*>& values,
                     const std::string& data_directory) {
  DescriptionTrees trees;
  const YamlNode* scene = &study.scene;
  const YamlNode* machine = study.machine ? &*study.machine : nullptr;
  std::vector<Override> changes = study.changes;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Axis& axis = study.axes[i];
    if (values[i] == nullptr) {
      continue;
    }
    if (is_whole_scene(axis)) {
      scene = &values[i]->node;
    } else if (is_whole_machine(axis)) {
      machine = &values[i]->node;
    } else {
      changes.push_back({axis.steps, values[i]->node});
    }
  }
  trees.scene = *scene;
  if (machine != nullptr) {
    trees.machine = *machine;
  }
  return read_description(std::move(trees), changes, data_directory);
}

std::string text_without_name(Machine machine) {
  machine.name.clear();
  return write_yaml(write_machine(std::move(machine)));
}

}  // namespace

StudyPoints::StudyPoints(Study study, std::string data_directory)
    : study_(std::move(study)),
      data_(std::move(data_directory)),
      own_(describe(study_, {}, data_)),
      points_(study_, own_) {
  DescriptionSources sources;
  sources.data_directory = data_;
  std::vector<InputFile> input_files;
  prototype_ = text_without_name(load_machine(sources, input_files));
}

Description StudyPoints::description(int point) const {
  return describe(study_, points_.values(point), data_);
}

std::vector<PointParameter> StudyPoints::parameters(int point) const {
  const std::vector<const AxisValue*> values = points_.values(point);
  std::vector<PointParameter> parameters;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string& path = study_.axes[i].path;
    parameters.push_back(
        {path, values[i] != nullptr ? values[i]->text : own_.at(path).value_or("")});
  }
  return parameters;
}

std::string StudyPoints::sentence(std::size_t axis) const {
  return own_.sentence(study_.axes[axis].path);
}

bool StudyPoints::is_prototype(const Description& description) const {
  return text_without_name(description.machine) == prototype_;
}

}  // namespace maquette::sim
