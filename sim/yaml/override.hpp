#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// What `--set path=value` asks for. Messages about it name `--set path=value` as their file.
struct Override {
  struct Step {
    std::string key;
    YamlPlace place;
  };
  std::vector<Step> path;  ///< one step or more
  YamlNode value;
};

/// Reads "path.to.parameter=value"; the value is YAML. Throws DescriptionError.
[[nodiscard]] Override parse_override(const std::string& text);

/// The steps of "path.to.parameter", which stands at `place`. Throws DescriptionError.
[[nodiscard]] std::vector<Override::Step> parse_path(const std::string& path,
                                                     const YamlPlace& place);

/// "path.to.parameter" of its steps.
[[nodiscard]] std::string path_of(const std::vector<Override::Step>& steps);

/// Puts the value in its place below `root`, starting with step `first` of the path. Steps into
/// mappings are keys, which are made if they are missing; steps into lists are numbers from 0.
/// Throws DescriptionError when a step leads nowhere.
void apply_override(YamlNode& root, const Override& change, std::size_t first = 0);

/// Whether a node was written in an option of the command line rather than in a file.
[[nodiscard]] bool is_from_override(const YamlPlace& place);

}  // namespace maquette::sim
