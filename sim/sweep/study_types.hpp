#pragma once

#include <string_view>
#include <vector>

#include "sim/sweep/axis.hpp"
#include "sim/yaml/override.hpp"
#include "sim/yaml/yaml_node.hpp"

/// The types of values that only studies have.
namespace maquette::sim {

/// Anything, to be read later.
struct NodeType {
  [[nodiscard]] static YamlNode read(const YamlNode& node, std::string_view /*name*/) {
    return node;
  }
  [[nodiscard]] static YamlNode write(const YamlNode& node) { return node; }
};

/// A mapping from paths to values.
struct ChangesType {
  [[nodiscard]] static std::vector<Override> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<Override>& changes);
};

/// A mapping from paths to what read_axis reads.
struct AxesType {
  [[nodiscard]] static std::vector<Axis> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<Axis>& axes);
};

}  // namespace maquette::sim
