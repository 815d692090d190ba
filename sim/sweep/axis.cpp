#include "sim/sweep/axis.hpp"

#include <memory>
#include <string_view>
#include <utility>

#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {
namespace {

constexpr const char* k_option = "--vary ";

/// A part of a text and where it begins.
struct Part {
  std::string text;
  std::size_t offset;
};

/// Splits at commas that stand in no brackets and no quotes.
std::vector<Part> split(const std::string& text) {
  std::vector<Part> parts;
  int depth = 0;
  char quote = 0;
  std::size_t start = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    const char letter = i < text.size() ? text[i] : ',';
    if (quote != 0) {
      quote = letter == quote ? '\0' : quote;
    } else if (letter == '"' || letter == '\'') {
      quote = letter;
    } else if (letter == '[' || letter == '{') {
      ++depth;
    } else if (letter == ']' || letter == '}') {
      --depth;
    }
    if (i == text.size() || (letter == ',' && depth == 0 && quote == 0)) {
      parts.push_back({text.substr(start, i - start), start});
      start = i + 1;
    }
  }
  return parts;
}

void add_value(Axis& axis, std::string text, YamlNode node) {
  axis.pieces.emplace_back(AxisValue{std::move(text), std::move(node)});
}

/// Refuses two whole numbers with a dash between them, which others write for a range.
void refuse_dash(const std::string& text, const YamlPlace& place) {
  constexpr const char* k_digits = "0123456789";
  const std::size_t dash = text.find_first_not_of(k_digits);
  if (dash == std::string::npos || dash == 0 || text[dash] != '-' || dash + 1 == text.size() ||
      text.find_first_not_of(k_digits, dash + 1) != std::string::npos) {
    return;
  }
  throw DescriptionError(place.position(), "`" + text + "` is no range; did you mean `" +
                                               text.substr(0, dash) + ".." + text.substr(dash + 1) +
                                               "`?");
}

/// Adds what a text stands for: ranges and values between commas.
void add_text(Axis& axis, const std::string& text, const YamlPlace& place) {
  for (const Part& part : split(text)) {
    const std::size_t blanks = std::min(part.text.find_first_not_of(' '), part.text.size());
    const YamlPlace start{place.file, place.line,
                          place.column + static_cast<int>(part.offset + blanks)};
    if (blanks == part.text.size()) {
      throw DescriptionError(start.position(), "a value is missing");
    }
    if (std::optional<ValueRange> range = read_range(part.text, start)) {
      axis.pieces.emplace_back(std::move(*range));
      continue;
    }
    refuse_dash(part.text.substr(blanks), start);
    YamlNode node = parse_yaml(part.text.substr(blanks), *place.file, start.column);
    std::string value = text_of(node);
    add_value(axis, std::move(value), std::move(node));
  }
}

void add_item(Axis& axis, const YamlNode& item) {
  if (item.kind == YamlKind::scalar) {
    if (std::optional<ValueRange> range = read_range(item.text, item.place)) {
      axis.pieces.emplace_back(std::move(*range));
      return;
    }
  }
  add_value(axis, text_of(item), item);
}

std::string range_text(const ValueRange& range) {
  const auto number = [](double value) { return write_measure({value, ""}); };
  std::string text = range.is_logarithmic ? "log " : "";
  text += number(range.first) + ".." + write_measure({range.last, range.unit});
  text += range.step ? ":" + number(*range.step) : "";
  text += range.count ? " of " + std::to_string(*range.count) : "";
  return text;
}

/// Whether reading the value's node back gives the value's text.
bool speaks_for_itself(const AxisValue& value) { return value.text == text_of(value.node); }

}  // namespace

std::string text_of(const YamlNode& value) {
  return value.kind == YamlKind::scalar ? value.text : write_flow(value);
}

Axis parse_axis(const std::string& text) {
  const auto file = std::make_shared<const std::string>(k_option + text);
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) {
    throw DescriptionError({*file, 1, static_cast<int>(text.size()) + 1},
                           "`=` is missing; path.to.parameter=values is allowed");
  }
  Axis axis;
  axis.path = text.substr(0, equals);
  axis.steps = parse_path(axis.path, {file, 1, 1});
  add_text(axis, text.substr(equals + 1), {file, 1, static_cast<int>(equals) + 2});
  return axis;
}

Axis read_axis(const std::string& path, const YamlPlace& place, const YamlNode& values) {
  Axis axis;
  axis.path = path;
  axis.steps = parse_path(path, place);
  switch (values.kind) {
    case YamlKind::null:
      break;
    case YamlKind::scalar:
      add_text(axis, values.text, values.place);
      break;
    case YamlKind::sequence:
      for (const YamlNode& item : values.items) {
        add_item(axis, item);
      }
      break;
    case YamlKind::mapping:
      for (const YamlEntry& entry : values.entries) {
        add_value(axis, entry.key, entry.value);
      }
      break;
  }
  if (axis.pieces.empty()) {
    throw DescriptionError(values.place.position(), path + ": values are missing");
  }
  return axis;
}

YamlNode write_axis(const Axis& axis) {
  bool has_names = false;
  for (const auto& piece : axis.pieces) {
    const auto* value = std::get_if<AxisValue>(&piece);
    has_names = has_names || (value != nullptr && !speaks_for_itself(*value));
  }
  YamlNode node = has_names ? yaml_mapping() : yaml_sequence({});
  for (const auto& piece : axis.pieces) {
    const auto* value = std::get_if<AxisValue>(&piece);
    if (has_names) {
      append(node, value->text, value->node);
    } else {
      node.items.push_back(value == nullptr ? yaml_scalar(range_text(std::get<ValueRange>(piece)))
                                            : value->node);
    }
  }
  return node;
}

}  // namespace maquette::sim
