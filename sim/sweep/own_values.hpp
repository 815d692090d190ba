#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/fields/parameter_table.hpp"
#include "sim/scene/description_loader.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// What a description says of its parameters before a study varies them.
class OwnValues {
 public:
  explicit OwnValues(const Description& description);

  /// The value at a path of --set as text; nothing when nothing stands there.
  [[nodiscard]] std::optional<std::string> at(const std::string& path) const;

  /// Whether the parameter at this path is declared to be a whole number.
  [[nodiscard]] bool is_whole(const std::string& path) const;

  /// The declared sentence of the parameter at this path; "" when it is not declared.
  [[nodiscard]] std::string sentence(const std::string& path) const;

 private:
  [[nodiscard]] const ParameterRow* row_at(const std::string& path) const;

  YamlNode tree_;
  std::vector<ParameterRow> rows_;
};

}  // namespace maquette::sim
