#include "sim/fields/value_types.hpp"

#include <algorithm>
#include <charconv>
#include <stdexcept>
#include <system_error>

#include "sim/yaml/name_check.hpp"
#include "sim/yaml/nearest_name.hpp"

namespace maquette::sim {
namespace {

[[noreturn]] void fail(const YamlNode& node, std::string_view name, const std::string& message) {
  throw DescriptionError(node.place.position(), std::string{name} + ": " + message);
}

std::string scalar_text(const YamlNode& node, std::string_view name, const std::string& expected) {
  if (node.kind != YamlKind::scalar) {
    fail(node, name, node.kind_name() + " stands here; " + expected + " is allowed");
  }
  return node.text;
}

template <class Value, class Dimension>
std::string range_text(const Range<Value>& bounds, Dimension dimension) {
  const std::string maximum = format_quantity(bounds.maximum, dimension);
  const std::string minimum = format_quantity(bounds.minimum, dimension);
  return bounds.above_minimum ? "above " + minimum + ", to " + maximum : minimum + " to " + maximum;
}

template <class Value, class Dimension>
Value read_quantity(const YamlNode& node, std::string_view name, const Range<Value>& bounds,
                    Dimension dimension) {
  const std::string text = scalar_text(
      node, name,
      "a number (" + range_text(bounds, dimension) + ", units: " + unit_list(dimension) + ")");
  Value value{};
  try {
    value = parse_quantity(text, dimension);
  } catch (const std::invalid_argument& error) {
    fail(node, name, error.what());
  }
  if (value < bounds.minimum || value > bounds.maximum ||
      (bounds.above_minimum && value == bounds.minimum)) {
    fail(node, name, "`" + text + "` is out of range; allowed: " + range_text(bounds, dimension));
  }
  return value;
}

}  // namespace

double RealType::read(const YamlNode& node, std::string_view name) const {
  return read_quantity(node, name, bounds, dimension);
}

YamlNode RealType::write(double value) const {
  return yaml_scalar(format_quantity(value, dimension));
}

std::string RealType::range() const { return range_text(bounds, dimension); }

std::int64_t WholeType::read(const YamlNode& node, std::string_view name) const {
  return read_quantity(node, name, bounds, dimension);
}

YamlNode WholeType::write(std::int64_t value) const {
  return yaml_scalar(format_quantity(value, dimension));
}

std::string WholeType::range() const { return range_text(bounds, dimension); }

glm::dvec3 TripleType::read(const YamlNode& node, std::string_view name) const {
  if (one_for_all && node.kind == YamlKind::scalar) {
    return glm::dvec3{read_quantity(node, name, bounds, RealDimension::number)};
  }
  if (node.kind != YamlKind::sequence || node.items.size() != 3) {
    const std::string found = node.kind == YamlKind::sequence
                                  ? "a list of " + std::to_string(node.items.size())
                                  : node.kind_name();
    fail(node, name,
         found + " stands here; " + (one_for_all ? "one number or " : "") +
             "a list of three numbers is allowed");
  }
  glm::dvec3 value{0};
  for (int i = 0; i < 3; ++i) {
    value[i] =
        read_quantity(node.items[static_cast<std::size_t>(i)], name, bounds, RealDimension::number);
  }
  return value;
}

YamlNode TripleType::write(const glm::dvec3& value) {
  std::vector<YamlNode> items;
  items.reserve(3);
  for (int i = 0; i < 3; ++i) {
    items.push_back(yaml_scalar(format_quantity(value[i], RealDimension::number)));
  }
  return yaml_sequence(std::move(items));
}

std::string TripleType::range() const {
  return "three of " + range_text(bounds, RealDimension::number);
}

std::vector<glm::dvec2> PointListType::read(const YamlNode& node, std::string_view name) const {
  if (node.kind != YamlKind::sequence) {
    fail(node, name, node.kind_name() + " stands here; a list of pairs of numbers is allowed");
  }
  std::vector<glm::dvec2> points;
  points.reserve(node.items.size());
  for (const YamlNode& item : node.items) {
    if (item.kind != YamlKind::sequence || item.items.size() != 2) {
      fail(item, name, item.kind_name() + " stands here; a list of two numbers is allowed");
    }
    points.emplace_back(read_quantity(item.items[0], name, bounds, RealDimension::number),
                        read_quantity(item.items[1], name, bounds, RealDimension::number));
  }
  return points;
}

YamlNode PointListType::write(const std::vector<glm::dvec2>& points) {
  std::vector<YamlNode> items;
  items.reserve(points.size());
  for (const glm::dvec2& point : points) {
    items.push_back(yaml_sequence({yaml_scalar(format_quantity(point.x, RealDimension::number)),
                                   yaml_scalar(format_quantity(point.y, RealDimension::number))}));
  }
  return yaml_sequence(std::move(items));
}

std::string TextType::read(const YamlNode& node, std::string_view name) {
  return scalar_text(node, name, "a text");
}

std::string FileNameType::read(const YamlNode& node, std::string_view name) {
  std::string text = scalar_text(node, name, range());
  if (!text.empty()) {
    check_file_name(text, node.place, name);
  }
  return text;
}

std::vector<std::uint8_t> HexadecimalType::read(const YamlNode& node, std::string_view name) {
  constexpr int k_base = 16;
  const std::string text = scalar_text(node, name, range());
  std::vector<std::uint8_t> bytes(text.size() / 2);
  bool is_right = text.size() % 2 == 0;
  for (std::size_t i = 0; i < bytes.size() && is_right; ++i) {
    const char* const end = text.data() + 2 * i + 2;
    const std::from_chars_result result = std::from_chars(end - 2, end, bytes[i], k_base);
    is_right = result.ec == std::errc{} && result.ptr == end;
  }
  if (!is_right) {
    fail(node, name, "these are not " + range() + ", which are allowed");
  }
  return bytes;
}

YamlNode HexadecimalType::write(const std::vector<std::uint8_t>& bytes) {
  constexpr std::string_view k_digits = "0123456789abcdef";
  std::string text;
  text.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) {
    text += k_digits[byte >> 4];
    text += k_digits[byte & 0xF];
  }
  return yaml_scalar(std::move(text));
}

bool FlagType::read(const YamlNode& node, std::string_view name) {
  const std::string text = scalar_text(node, name, "true or false");
  if (text != "true" && text != "false") {
    fail(node, name, "`" + text + "` is not known; allowed: true, false");
  }
  return text == "true";
}

std::size_t read_choice(const YamlNode& node, std::string_view name,
                        const std::vector<std::string_view>& names) {
  const std::string text = scalar_text(node, name, "one of the names");
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end()) {
    fail(node, name, "`" + text + "` is not known; " + allowed_names(text, names));
  }
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace maquette::sim
