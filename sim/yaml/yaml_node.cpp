#include "sim/yaml/yaml_node.hpp"

#include <algorithm>
#include <utility>

namespace maquette::sim {

namespace {

constexpr std::size_t k_most_shown = 100;  // letters of a text in a message

}  // namespace

SourcePosition YamlPlace::position() const { return {file ? *file : std::string{}, line, column}; }

const YamlNode* YamlNode::find(std::string_view key) const {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const YamlEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

YamlNode* YamlNode::find(std::string_view key) {
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const YamlEntry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

std::string YamlNode::kind_name() const {
  switch (kind) {
    case YamlKind::null:
      return "nothing";
    case YamlKind::scalar:
      return "`" + (text.size() > k_most_shown ? text.substr(0, k_most_shown) + "..." : text) + "`";
    case YamlKind::sequence:
      return "a list";
    case YamlKind::mapping:
      return "a mapping";
  }
  return {};
}

YamlNode yaml_scalar(std::string text) {
  YamlNode node;
  node.kind = YamlKind::scalar;
  node.text = std::move(text);
  return node;
}

YamlNode yaml_sequence(std::vector<YamlNode> items) {
  YamlNode node;
  node.kind = YamlKind::sequence;
  node.items = std::move(items);
  return node;
}

YamlNode yaml_mapping() {
  YamlNode node;
  node.kind = YamlKind::mapping;
  return node;
}

void append(YamlNode& mapping, std::string_view key, YamlNode value) {
  mapping.entries.push_back({std::string{key}, {}, std::move(value)});
}

const YamlNode& nearest_node(const YamlNode& root, std::string_view path) {
  const YamlNode* node = &root;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    const YamlNode* child = node->find(path.substr(0, dot));
    if (child == nullptr) {
      break;
    }
    node = child;
    path = dot == std::string_view::npos ? std::string_view{} : path.substr(dot + 1);
  }
  return *node;
}

}  // namespace maquette::sim
