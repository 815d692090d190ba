#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"
#include "sim/yaml/input_file.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// A scene of a directory.
struct ShippedScene {
  std::string name;  ///< of the file, relative to the directory, without its ending
  InputFile file;    ///< as it was read
  YamlNode written;  ///< before it is checked
  Scene scene;
};

/// Every scene in a directory and those below it, studies left out, in the order of their names.
/// Throws DescriptionError when there is none or one of them is wrong.
[[nodiscard]] std::vector<ShippedScene> shipped_scenes(const std::string& directory);

}  // namespace maquette::sim
