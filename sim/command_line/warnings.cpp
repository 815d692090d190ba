#include "sim/command_line/warnings.hpp"

#include <fmt/format.h>

#include "sim/report/remark.hpp"
#include "sim/yaml/yaml_reader.hpp"

namespace maquette::sim {

void Warnings::tell(const SceneWarning& warning) {
  const YamlNode root = parse_yaml(description_.input_files.front());
  const SourcePosition position = nearest_node(root, warning.path).place.position();
  told_.push_back(fmt::format("{}:{}:{}: warning: {}", position.file, position.line,
                              position.column, warning.text));
  remark(told_.back() + "\n");
}

}  // namespace maquette::sim
