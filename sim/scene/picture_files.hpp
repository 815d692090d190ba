#pragma once

#include <string>
#include <vector>

#include "sim/yaml/input_file.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Puts the texels of pictures in the place of the names of their files, which are PNG files of
/// three 8-bit channels, in the surfaces of a scene that was not read yet. The names are relative
/// to the file that holds them, in overrides to where the program runs. What was read is appended
/// to `input_files`. Throws DescriptionError.
void inline_pictures(YamlNode& scene, std::vector<InputFile>& input_files);

}  // namespace maquette::sim
