#pragma once

#include <string>
#include <variant>
#include <vector>

#include "sim/sweep/value_range.hpp"
#include "sim/yaml/override.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// One value of an axis: what stands in tables and plots, and what goes into the description.
struct AxisValue {
  std::string text;
  YamlNode node;
};

/// A parameter that a study varies, with its values as they were written.
struct Axis {
  std::string path;  ///< as for --set; `scene` and `machine` stand for whole descriptions
  std::vector<Override::Step> steps;
  std::vector<std::variant<AxisValue, ValueRange>> pieces;
};

/// Reads "path=values" of --vary; values are separated by commas outside of brackets. Throws
/// DescriptionError, whose file is "--vary path=values".
[[nodiscard]] Axis parse_axis(const std::string& text);

/// Reads the values of an axis of a study file: a text as for --vary, a list of values and ranges,
/// or a mapping from names to values. Throws DescriptionError.
[[nodiscard]] Axis read_axis(const std::string& path, const YamlPlace& place,
                             const YamlNode& values);

/// The values as read_axis reads them back.
[[nodiscard]] YamlNode write_axis(const Axis& axis);

/// The text that stands for a value in tables.
[[nodiscard]] std::string text_of(const YamlNode& value);

}  // namespace maquette::sim
