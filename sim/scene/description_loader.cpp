#include "sim/scene/description_loader.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <utility>

#include "sim/machine/machine_description.hpp"
#include "sim/scene/picture_files.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/scene/sequence.hpp"
#include "sim/scene/shipped_descriptions.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/nearest_name.hpp"
#include "sim/yaml/override.hpp"
#include "sim/yaml/yaml_node.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view k_default_machine = "ccett-1984";

/// A table that a board or a function unit may name; both its key in the board and the kind of what
/// is shipped.
struct CostTable {
  std::string_view key;
  std::string_view standard;  ///< stands for a board's where none is named
};
constexpr std::array<CostTable, 2> k_cost_tables{
    {{"arithmetic", "motorola_ffp"}, {"program", "mc68000"}}};

/// Reads files and remembers them.
class Loader {
 public:
  Loader(std::string data_directory, std::vector<InputFile>& input_files)
      : data_(std::move(data_directory)), input_files_(input_files) {}

  /// Those that were read before; kept by reference.
  void know(const std::vector<InputFile>& files) { known_ = &files; }

  YamlNode load(const std::string& file) {
    input_files_.push_back(read(file));
    return parse_yaml(input_files_.back());
  }

  /// Loads what `name` refers to: a file relative to `base`, or what is shipped of `kind`. `place`
  /// is where the name was written; nothing for the command line.
  YamlNode load_named(const std::string& name, std::string_view kind, const fs::path& base,
                      const YamlPlace* place) {
    return load(description_file(name, {kind}, data_, base, place));
  }

  void expand_pictures(YamlNode& scene) { inline_pictures(scene, input_files_); }

  /// Replaces a name that stands for a description by that description.
  void expand(YamlNode& node, std::string_view kind) {
    if (node.kind == YamlKind::scalar) {
      const YamlPlace place = node.place;
      const std::string name = node.text;
      node = load_named(name, kind, directory_of(place), &place);
    }
  }

 private:
  /// Names in overrides are relative to where the program runs.
  static fs::path directory_of(const YamlPlace& place) {
    return place.file && !is_from_override(place) ? fs::path{*place.file}.parent_path()
                                                  : fs::path{};
  }

  [[nodiscard]] InputFile read(const std::string& file) const {
    if (known_ != nullptr) {
      const auto found = std::find_if(known_->begin(), known_->end(),
                                      [&file](const InputFile& f) { return f.path == file; });
      if (found != known_->end()) {
        return *found;
      }
    }
    return read_input(file);
  }

  std::string data_;
  std::vector<InputFile>& input_files_;
  const std::vector<InputFile>* known_ = nullptr;
};

/// Makes the value under `key` of a mapping and returns it.
YamlNode& value_of(YamlNode& mapping, std::string_view key) {
  if (YamlNode* value = mapping.find(key)) {
    return *value;
  }
  mapping.entries.push_back({std::string{key}, mapping.place, {}});
  mapping.entries.back().value.place = mapping.place;
  return mapping.entries.back().value;
}

/// Puts a cost table in the place of its name.
void expand_table(YamlNode& board, const CostTable& kind, Loader& loader) {
  YamlNode& table = value_of(board, kind.key);
  if (table.kind == YamlKind::null) {
    const YamlPlace place = table.place;
    table = yaml_scalar(std::string{kind.standard});
    table.place = place;
  }
  loader.expand(table, kind.key);
}

/// Those that units name.
void expand_unit_tables(YamlNode& machine, Loader& loader) {
  YamlNode* units = machine.find("units");
  if (units == nullptr) {
    return;
  }
  for (YamlEntry& kind : units->entries) {
    for (const CostTable& table : k_cost_tables) {
      if (YamlNode* const node = kind.value.find(table.key)) {
        loader.expand(*node, table.key);
      }
    }
  }
}

/// Puts the cost tables of the machine's boards and units in the places of their names.
void expand_tables(YamlNode& machine, Loader& loader) {
  if (machine.kind != YamlKind::mapping) {
    return;
  }
  expand_unit_tables(machine, loader);
  YamlNode& board = value_of(machine, "board");
  if (board.kind == YamlKind::null) {
    board.kind = YamlKind::mapping;
  }
  if (board.kind != YamlKind::mapping) {
    return;
  }
  for (const CostTable& table : k_cost_tables) {
    expand_table(board, table, loader);
  }
}

bool is_cost_table(std::string_view key) {
  return std::any_of(k_cost_tables.begin(), k_cost_tables.end(),
                     [key](const CostTable& table) { return table.key == key; });
}

/// Whether the path, from step `first` on, leads to what stands in a cost table.
bool leads_into_table(const std::vector<Override::Step>& path, std::size_t first) {
  const std::size_t of_board = path[first].key == "board" ? first + 1 : path.size();
  const std::size_t table = path[first].key == "units" ? first + 2 : of_board;
  return table + 1 < path.size() && is_cost_table(path[table].key);
}

bool contains(const std::vector<std::string_view>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void apply_to_machine(YamlNode& machine, const Override& change, std::size_t first,
                      Loader& loader) {
  if (change.path.size() == first) {
    machine = change.value;
    loader.expand(machine, "machines");
    return;
  }
  if (leads_into_table(change.path, first)) {
    expand_tables(machine, loader);
  }
  apply_override(machine, change, first);
}

void apply_to_both(YamlNode& scene, YamlNode& machine, const Override& change, Loader& loader) {
  const std::string& key = change.path.front().key;
  if (key == "machine") {
    apply_to_machine(machine, change, 1, loader);
  } else if (contains(scene_keys(), key)) {
    apply_override(scene, change);
  } else if (contains(machine_keys(), key)) {
    apply_to_machine(machine, change, 0, loader);
  } else {
    std::vector<std::string_view> allowed = scene_keys();
    for (const std::string_view other : machine_keys()) {
      if (!contains(allowed, other)) {
        allowed.push_back(other);
      }
    }
    throw DescriptionError(change.path.front().place.position(),
                           "`" + key + "` is not known; " + allowed_names(key, allowed));
  }
}

/// Takes the scene's own machine out of the scene; null when it has none.
YamlNode take_machine(YamlNode& scene) {
  YamlNode machine;
  for (auto entry = scene.entries.begin(); entry != scene.entries.end(); ++entry) {
    if (entry->key == "machine") {
      machine = std::move(entry->value);
      scene.entries.erase(entry);
      break;
    }
  }
  return machine;
}

/// The scenes of a sequence's frames.
std::vector<Scene> frames_of(const YamlNode& scene, const std::optional<Sequence>& sequence,
                             Loader& loader) {
  std::vector<Scene> frames;
  for (int frame = 0; sequence && frame < sequence->frames; ++frame) {
    YamlNode tree = frame_of(scene, *sequence, frame);
    loader.expand_pictures(tree);
    frames.push_back(read_scene(tree));
  }
  return frames;
}

Description read_trees(DescriptionTrees trees, const std::vector<Override>& changes,
                       Loader& loader) {
  YamlNode own_machine = take_machine(trees.scene);
  YamlNode& machine = trees.machine.kind == YamlKind::null ? own_machine : trees.machine;
  if (machine.kind == YamlKind::null) {
    machine = loader.load_named(std::string{k_default_machine}, "machines", {}, nullptr);
  }
  loader.expand(machine, "machines");
  for (const Override& change : changes) {
    apply_to_both(trees.scene, machine, change, loader);
  }
  expand_tables(machine, loader);
  loader.expand_pictures(trees.scene);
  Scene scene = read_scene(trees.scene);
  std::vector<Scene> frames = frames_of(trees.scene, scene.sequence, loader);
  return {std::move(scene), std::move(frames), read_machine(machine), {}};
}

void expand_machine(YamlNode& machine, Loader& loader) {
  loader.expand(machine, "machines");
  expand_tables(machine, loader);
}

}  // namespace

void inline_files(YamlNode& part, DescriptionPart kind, const std::string& data_directory,
                  std::vector<InputFile>& input_files) {
  Loader loader{data_directory, input_files};
  switch (kind) {
    case DescriptionPart::scene:
      loader.expand(part, "scenes");
      loader.expand_pictures(part);
      if (YamlNode* machine = part.find("machine")) {
        expand_machine(*machine, loader);
      }
      break;
    case DescriptionPart::machine:
      expand_machine(part, loader);
      break;
    case DescriptionPart::arithmetic:
      loader.expand(part, "arithmetic");
      break;
    case DescriptionPart::program:
      loader.expand(part, "program");
      break;
  }
}

Description read_description(DescriptionTrees trees, const std::vector<Override>& changes,
                             const std::string& data_directory) {
  std::vector<InputFile> input_files;
  Loader loader{data_directory, input_files};
  return read_trees(std::move(trees), changes, loader);
}

Description load_description(const DescriptionSources& sources) {
  std::vector<InputFile> input_files;
  Loader loader{sources.data_directory, input_files};
  loader.know(sources.known);
  DescriptionTrees trees;
  trees.scene = loader.load(sources.scene_file);
  if (sources.machine) {
    trees.machine = loader.load_named(*sources.machine, "machines", {}, nullptr);
  }
  std::vector<Override> changes;
  for (const std::string& text : sources.overrides) {
    changes.push_back(parse_override(text));
  }
  Description description = read_trees(std::move(trees), changes, loader);
  description.input_files = std::move(input_files);
  return description;
}

Machine load_machine(const DescriptionSources& sources, std::vector<InputFile>& input_files) {
  Loader loader{sources.data_directory, input_files};
  loader.know(sources.known);
  YamlNode machine = loader.load_named(sources.machine.value_or(std::string{k_default_machine}),
                                       "machines", {}, nullptr);
  for (const std::string& text : sources.overrides) {
    const Override change = parse_override(text);
    apply_to_machine(machine, change, change.path.front().key == "machine" ? 1 : 0, loader);
  }
  expand_tables(machine, loader);
  return read_machine(machine);
}

bool describes_machine(const InputFile& file) {
  const YamlNode root = parse_yaml(file);
  return root.find("object") == nullptr && root.find("view") == nullptr &&
         (root.find("processors") != nullptr || root.find("board") != nullptr);
}

std::string effective_configuration(const Scene& scene, const Machine& machine) {
  YamlNode root = write_scene(scene);
  append(root, "machine", write_machine(machine));
  return write_yaml(root);
}

}  // namespace maquette::sim
