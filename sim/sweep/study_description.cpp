#include "sim/sweep/study_description.hpp"

#include <filesystem>
#include <optional>
#include <set>
#include <string_view>

#include "sim/sweep/study_fields.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {
namespace {

bool ends_with(std::string_view path, std::string_view end) {
  return path.size() >= end.size() && path.substr(path.size() - end.size()) == end;
}

/// What a parameter of this path holds, when that is a description of its own.
std::optional<DescriptionPart> part_at(std::string_view path) {
  if (path == "scene") {
    return DescriptionPart::scene;
  }
  if (path == "machine") {
    return DescriptionPart::machine;
  }
  if (ends_with(path, ".arithmetic")) {
    return DescriptionPart::arithmetic;
  }
  if (ends_with(path, ".program")) {
    return DescriptionPart::program;
  }
  return std::nullopt;
}

/// A scene without a machine, in a study without one, gets the prototype.
void give_machine(YamlNode& scene, const std::optional<YamlNode>& machine) {
  if (!machine && scene.kind == YamlKind::mapping && scene.find("machine") == nullptr) {
    append(scene, "machine", yaml_scalar("ccett-1984"));
  }
}

class Inliner {
 public:
  Inliner(const std::string& data_directory, std::vector<InputFile>& input_files)
      : data_(data_directory), input_files_(input_files) {}

  void scene(YamlNode& scene, const std::optional<YamlNode>& machine) const {
    inline_files(scene, DescriptionPart::scene, data_, input_files_);
    give_machine(scene, machine);
    inline_files(scene, DescriptionPart::scene, data_, input_files_);
  }

  void part(YamlNode& node, DescriptionPart kind, const std::optional<YamlNode>& machine) const {
    switch (kind) {
      case DescriptionPart::scene:
        scene(node, machine);
        break;
      case DescriptionPart::machine:
      case DescriptionPart::arithmetic:
      case DescriptionPart::program:
        inline_files(node, kind, data_, input_files_);
        break;
    }
  }

 private:
  const std::string& data_;
  std::vector<InputFile>& input_files_;
};

/// The name of a file without directory and ending; another text as it is.
std::string name_of_description(const std::string& text) {
  return std::filesystem::path(text).stem().string();
}

void inline_axis(Axis& axis, DescriptionPart kind, const Study& study, const Inliner& inliner) {
  std::set<std::string> names;
  for (auto& piece : axis.pieces) {
    auto* value = std::get_if<AxisValue>(&piece);
    if (value == nullptr) {
      throw DescriptionError(std::get<ValueRange>(piece).place.position(),
                             axis.path + ": a range stands here; names are allowed");
    }
    if (value->node.kind == YamlKind::scalar) {
      value->text = name_of_description(value->text);
    }
    if (!names.insert(value->text).second) {
      throw DescriptionError(value->node.place.position(),
                             axis.path + ": two values have the name `" + value->text + "`");
    }
    inliner.part(value->node, kind, study.machine);
  }
}

void check_paths(const Study& study) {
  std::set<std::string> paths;
  for (const Axis& axis : study.axes) {
    if (!paths.insert(axis.path).second) {
      throw DescriptionError(axis.steps.front().place.position(),
                             "`" + axis.path + "` is varied twice");
    }
  }
  for (const Override& change : study.changes) {
    if (paths.count(path_of(change.path)) != 0) {
      throw DescriptionError(change.path.front().place.position(),
                             "`" + path_of(change.path) + "` is varied and cannot be set too");
    }
  }
}

/// A later value of the same parameter replaces an earlier one.
void drop_replaced(std::vector<Override>& changes) {
  std::set<std::string> later;
  for (std::size_t i = changes.size(); i > 0; --i) {
    if (!later.insert(path_of(changes[i - 1].path)).second) {
      changes.erase(changes.begin() + static_cast<std::ptrdiff_t>(i - 1));
    }
  }
}

}  // namespace

Study read_study(const std::string& file) { return read_study(load_yaml(file)); }

Study read_study(const YamlNode& root) {
  Study study;
  FieldReader reader{root, "study"};
  declare_study(reader, study);
  reader.finish();
  return study;
}

void inline_files(Study& study, const std::string& data_directory,
                  std::vector<InputFile>& input_files) {
  check_paths(study);
  drop_replaced(study.changes);
  const Inliner inliner{data_directory, input_files};
  if (study.machine) {
    inliner.part(*study.machine, DescriptionPart::machine, study.machine);
  }
  inliner.scene(study.scene, study.machine);
  for (Override& change : study.changes) {
    if (const auto kind = part_at(path_of(change.path))) {
      inliner.part(change.value, *kind, study.machine);
    }
  }
  for (Axis& axis : study.axes) {
    if (const auto kind = part_at(axis.path)) {
      inline_axis(axis, *kind, study, inliner);
    }
  }
}

std::string write_study(Study study) {
  FieldWriter writer;
  declare_study(writer, study);
  return write_yaml(writer.take());
}

std::string identity_of(Study study) {
  FieldWriter writer;
  declare_points(writer, study);
  return write_yaml(writer.take());
}

}  // namespace maquette::sim
