#include "sim/yaml/override.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <system_error>
#include <utility>

#include "sim/yaml/description_error.hpp"
#include "sim/yaml/nearest_name.hpp"
#include "sim/yaml/yaml_reader.hpp"

namespace maquette::sim {
namespace {

constexpr const char* k_option = "--set ";

[[noreturn]] void fail(const Override::Step& step, const std::string& message) {
  throw DescriptionError(step.place.position(), "`" + step.key + "`: " + message);
}

YamlNode& list_item(YamlNode& list, const Override::Step& step) {
  std::size_t index = 0;
  const char* end = step.key.data() + step.key.size();
  const auto result = std::from_chars(step.key.data(), end, index);
  if (result.ec != std::errc{} || result.ptr != end || index >= list.items.size()) {
    fail(step, list.items.empty() ? "the list is empty"
                                  : "a list stands here; a number from 0 to " +
                                        std::to_string(list.items.size() - 1) + " is allowed");
  }
  return list.items[index];
}

YamlNode& mapping_value(YamlNode& mapping, const Override::Step& step) {
  if (mapping.kind == YamlKind::null) {
    mapping.kind = YamlKind::mapping;
    mapping.place = step.place;
  }
  if (YamlNode* value = mapping.find(step.key)) {
    return *value;
  }
  mapping.entries.push_back({step.key, step.place, {}});
  return mapping.entries.back().value;
}

/// Lights and surfaces have names of the user's own: a value inside of one that does not exist is a
/// slip, while a whole new one may be given.
void require_entry(const YamlNode& named, const Override::Step& step) {
  std::vector<std::string_view> names;
  for (const auto& entry : named.entries) {
    if (entry.key == step.key) {
      return;
    }
    names.emplace_back(entry.key);
  }
  fail(step, "there is none of this name; " + allowed_names(step.key, names));
}

}  // namespace

std::vector<Override::Step> parse_path(const std::string& path, const YamlPlace& place) {
  std::vector<Override::Step> steps;
  for (std::size_t start = 0; start <= path.size();) {
    const std::size_t end = std::min(path.find('.', start), path.size());
    const YamlPlace step{place.file, place.line, place.column + static_cast<int>(start)};
    if (end == start) {
      throw DescriptionError(step.position(), "a name is missing in the path");
    }
    steps.push_back({path.substr(start, end - start), step});
    start = end + 1;
  }
  return steps;
}

Override parse_override(const std::string& text) {
  const auto file = std::make_shared<const std::string>(k_option + text);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    throw DescriptionError({*file, 1, static_cast<int>(text.size()) + 1},
                           "`=` is missing; path.to.parameter=value is allowed");
  }
  Override change;
  change.path = parse_path(text.substr(0, equals), {file, 1, 1});
  change.value = parse_yaml(text.substr(equals + 1), *file, static_cast<int>(equals) + 2);
  return change;
}

std::string path_of(const std::vector<Override::Step>& steps) {
  std::string path;
  for (const Override::Step& step : steps) {
    path.append(path.empty() ? "" : ".").append(step.key);
  }
  return path;
}

void apply_override(YamlNode& root, const Override& change, std::size_t first) {
  YamlNode* node = &root;
  for (std::size_t i = first; i < change.path.size(); ++i) {
    const Override::Step& step = change.path[i];
    if (node->kind == YamlKind::scalar) {
      fail(step, "a single value stands above it: " + node->kind_name());
    }
    const bool is_named = i == first + 1 && (change.path[first].key == "lights" ||
                                             change.path[first].key == "surfaces");
    if (is_named && i + 1 < change.path.size()) {
      require_entry(*node, step);
    }
    node = node->kind == YamlKind::sequence ? &list_item(*node, step) : &mapping_value(*node, step);
  }
  *node = change.value;
}

bool is_from_override(const YamlPlace& place) {
  return place.file && place.file->rfind("--", 0) == 0;
}

}  // namespace maquette::sim
