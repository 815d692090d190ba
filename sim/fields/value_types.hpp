#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/fields/dimension.hpp"
#include "sim/fields/quantity.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_node.hpp"

/// The types of values in descriptions. Each type can `read` a node (`name` is for messages; throws
/// DescriptionError at the node), `write` a value as a node, and name its `unit` and `range`.
namespace maquette::sim {

/// Allowed values, bounds included; above_minimum leaves the lower bound out.
template <class Value>
struct Range {
  Value minimum;
  Value maximum;
  bool above_minimum = false;
};

/// Bounds of lengths and coordinates of a scene: their squares stay far from the limits of the
/// firmware's numbers.
inline constexpr double k_largest_length = 1e9;

inline constexpr std::int64_t k_mebibyte = 1'048'576;

struct RealType {
  RealDimension dimension;
  Range<double> bounds;

  [[nodiscard]] double read(const YamlNode& node, std::string_view name) const;
  [[nodiscard]] YamlNode write(double value) const;
  [[nodiscard]] std::string unit() const { return unit_list(dimension); }
  [[nodiscard]] std::string range() const;
};

struct WholeType {
  WholeDimension dimension;
  Range<std::int64_t> bounds;

  [[nodiscard]] std::int64_t read(const YamlNode& node, std::string_view name) const;
  [[nodiscard]] YamlNode write(std::int64_t value) const;
  [[nodiscard]] YamlNode write(std::chrono::duration<std::int64_t, std::pico> value) const {
    return write(value.count());
  }
  [[nodiscard]] std::string unit() const { return unit_list(dimension); }
  [[nodiscard]] std::string range() const;
};

/// A length in units of the scene that is not zero.
inline constexpr RealType k_length{RealDimension::number, {0, k_largest_length, true}};

/// Three numbers [x, y, z] or [red, green, blue]; one number stands for three equal ones if
/// `one_for_all`.
struct TripleType {
  Range<double> bounds;
  bool one_for_all = false;

  [[nodiscard]] glm::dvec3 read(const YamlNode& node, std::string_view name) const;
  [[nodiscard]] static YamlNode write(const glm::dvec3& value);
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] std::string range() const;
};

/// A list of points in a plane, each a list of two numbers.
struct PointListType {
  Range<double> bounds;

  [[nodiscard]] std::vector<glm::dvec2> read(const YamlNode& node, std::string_view name) const;
  [[nodiscard]] static YamlNode write(const std::vector<glm::dvec2>& points);
};

/// Free text.
struct TextType {
  [[nodiscard]] static std::string read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::string& value) { return yaml_scalar(value); }
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] static std::string range() { return "text"; }
};

/// What files or directories of results are called; empty where they are called by default.
struct FileNameType {
  [[nodiscard]] static std::string read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::string& value) { return yaml_scalar(value); }
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] static std::string range() { return "name of a file"; }
};

/// Bytes, two hexadecimal digits each.
struct HexadecimalType {
  [[nodiscard]] static std::vector<std::uint8_t> read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(const std::vector<std::uint8_t>& bytes);
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] static std::string range() { return "pairs of hexadecimal digits"; }
};

struct FlagType {
  [[nodiscard]] static bool read(const YamlNode& node, std::string_view name);
  [[nodiscard]] static YamlNode write(bool value) { return yaml_scalar(value ? "true" : "false"); }
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] static std::string range() { return "true, false"; }
};

/// The index of `node`'s text in `names`; throws DescriptionError with the allowed names.
[[nodiscard]] std::size_t read_choice(const YamlNode& node, std::string_view name,
                                      const std::vector<std::string_view>& names);

/// One of a few named values.
template <class Value>
struct ChoiceType {
  std::vector<std::pair<std::string_view, Value>> choices;

  [[nodiscard]] std::vector<std::string_view> names() const {
    std::vector<std::string_view> result;
    for (const auto& choice : choices) {
      result.push_back(choice.first);
    }
    return result;
  }
  [[nodiscard]] Value read(const YamlNode& node, std::string_view name) const {
    return choices[read_choice(node, name, names())].second;
  }
  [[nodiscard]] YamlNode write(Value value) const {
    for (const auto& choice : choices) {
      if (choice.second == value) {
        return yaml_scalar(std::string{choice.first});
      }
    }
    throw DescriptionError("a value has no name among its choices");
  }
  [[nodiscard]] static std::string unit() { return "none"; }
  [[nodiscard]] std::string range() const {
    std::string list;
    for (const auto& choice : choices) {
      list.append(list.empty() ? "" : ", ").append(choice.first);
    }
    return list;
  }
};

/// The rows of a table as choices, each under its `name`.
template <class Row, std::size_t size>
[[nodiscard]] ChoiceType<Row> choices_of(const Row (&rows)[size]) {
  ChoiceType<Row> type;
  for (const Row& row : rows) {
    type.choices.emplace_back(row.name, row);
  }
  return type;
}

/// Moves what a type read into the member that keeps it.
template <class Value, class Read>
void assign(Value& value, Read read) {
  if constexpr (std::is_same_v<Value, Read> || !std::is_integral_v<Read>) {
    value = std::move(read);
  } else if constexpr (std::is_integral_v<Value>) {
    value = static_cast<Value>(read);  // the range of the type fits the member
  } else {
    value = Value{read};
  }
}

}  // namespace maquette::sim
