#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// A description that comes with the program.
struct ShippedDescription {
  std::string name;  ///< of the file, without its ending
  std::string file;
};

/// Every description of a kind (`scenes`, `studies`, `machines`, `arithmetic` or `program`) in the
/// folder of data, in the order of their names.
[[nodiscard]] std::vector<ShippedDescription> shipped_descriptions(
    const std::string& data_directory, std::string_view kind);

/// The file that a name refers to: a file, relative to `base`, or else what is shipped under that
/// name in one of `kinds`; names of shipped descriptions hold neither `/` nor `.`. `place` is where
/// the name was written, nothing for the command line. Throws DescriptionError.
[[nodiscard]] std::string description_file(const std::string& name,
                                           const std::vector<std::string_view>& kinds,
                                           const std::string& data_directory,
                                           const std::filesystem::path& base = {},
                                           const YamlPlace* place = nullptr);

}  // namespace maquette::sim
