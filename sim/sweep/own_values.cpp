#include "sim/sweep/own_values.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <system_error>
#include <utility>

#include "sim/machine/machine_description.hpp"
#include "sim/scene/scene_description.hpp"
#include "sim/sweep/axis.hpp"
#include "sim/yaml/override.hpp"

namespace maquette::sim {
namespace {

constexpr const char* k_machine = "machine";

const YamlNode* item_at(const YamlNode& list, const std::string& key) {
  std::size_t index = 0;
  const char* end = key.data() + key.size();
  const auto result = std::from_chars(key.data(), end, index);
  return result.ec == std::errc{} && result.ptr == end && index < list.items.size()
             ? &list.items[index]
             : nullptr;
}

const YamlNode* node_at(const YamlNode& root, const std::vector<Override::Step>& steps) {
  const YamlNode* node = &root;
  for (const Override::Step& step : steps) {
    node = node->kind == YamlKind::sequence ? item_at(*node, step.key) : node->find(step.key);
    if (node == nullptr) {
      return nullptr;
    }
  }
  return node;
}

}  // namespace

OwnValues::OwnValues(const Description& description) : tree_(write_scene(description.scene)) {
  append(tree_, k_machine, write_machine(description.machine));
  for (std::vector<ParameterRow> rows :
       {list_parameters(description.scene), list_parameters(description.machine)}) {
    std::move(rows.begin(), rows.end(), std::back_inserter(rows_));
  }
}

std::optional<std::string> OwnValues::at(const std::string& path) const {
  const std::vector<Override::Step> steps = parse_path(path, {});
  const YamlNode* node = node_at(tree_, steps);
  node = node == nullptr ? node_at(*tree_.find(k_machine), steps) : node;
  if (path == "scene") {
    node = tree_.find("name");
  } else if (node != nullptr && node->kind == YamlKind::mapping) {
    node = node->find("name");
  }
  return node == nullptr ? std::nullopt : std::optional{text_of(*node)};
}

const ParameterRow* OwnValues::row_at(const std::string& path) const {
  const std::string prefix = std::string{k_machine} + ".";
  const bool names_machine = path.compare(0, prefix.size(), prefix) == 0;
  const std::string name = names_machine ? path.substr(prefix.size()) : path;
  const auto found = std::find_if(rows_.begin(), rows_.end(),
                                  [&name](const ParameterRow& row) { return row.path == name; });
  return found == rows_.end() ? nullptr : &*found;
}

bool OwnValues::is_whole(const std::string& path) const {
  const ParameterRow* row = row_at(path);
  return row != nullptr && row->is_whole;
}

std::string OwnValues::sentence(const std::string& path) const {
  const ParameterRow* row = row_at(path);
  return row == nullptr ? "" : row->sentence;
}

}  // namespace maquette::sim
