#include "sim/yaml/yaml_writer.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace maquette::sim {
namespace {

constexpr std::array<std::string_view, 5> k_words_for_null = {"", "~", "null", "Null", "NULL"};

bool is_letter_or_digit(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9');
}

/// Whether a text means itself without quotes, also within brackets and as a key.
bool is_plain(std::string_view text) {
  if (std::find(k_words_for_null.begin(), k_words_for_null.end(), text) != k_words_for_null.end()) {
    return false;
  }
  const bool starts_a_number =
      text.size() > 1 && text.front() == '-' && is_letter_or_digit(text[1]);
  if (!(is_letter_or_digit(text.front()) || starts_a_number) || text.back() == ' ') {
    return false;
  }
  return std::all_of(text.begin(), text.end(), [](char letter) {
    return is_letter_or_digit(letter) ||
           std::string_view{" _-+./%"}.find(letter) != std::string_view::npos;
  });
}

std::string quoted(std::string_view text) {
  constexpr std::string_view k_digits = "0123456789abcdef";
  std::string result = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      result.append(1, '\\').append(1, letter);
    } else if (code < 0x20 || code == 0x7F) {
      result.append("\\x").append(1, k_digits[code / 16]).append(1, k_digits[code % 16]);
    } else {
      result += letter;
    }
  }
  return result + "\"";
}

std::string write_text(std::string_view text) {
  return is_plain(text) ? std::string{text} : quoted(text);
}

/// Whether a node is short enough to stand on the line of its key.
bool is_short(const YamlNode& node) {
  switch (node.kind) {
    case YamlKind::null:
    case YamlKind::scalar:
      return true;
    case YamlKind::sequence:
      return std::all_of(node.items.begin(), node.items.end(),
                         [](const YamlNode& item) { return item.kind == YamlKind::scalar; });
    case YamlKind::mapping:
      return node.entries.empty();
  }
  return false;
}

void write_block(const YamlNode& node, std::size_t indentation, std::string& text);

/// The entries of a mapping; the first one continues the line that is open.
void write_entries(const YamlNode& node, std::size_t indentation, std::string& text) {
  bool first = true;
  for (const YamlEntry& entry : node.entries) {
    text.append(first ? 0 : indentation, ' ').append(write_text(entry.key)).append(":");
    first = false;
    if (is_short(entry.value)) {
      text.append(" ").append(write_flow(entry.value)).append("\n");
    } else {
      text.append("\n");
      write_block(entry.value, indentation + 2, text);
    }
  }
}

/// The items of a sequence, a line or more for each.
void write_items(const YamlNode& node, std::size_t indentation, std::string& text) {
  for (const YamlNode& item : node.items) {
    text.append(indentation, ' ').append("- ");
    if (item.kind == YamlKind::mapping && !item.entries.empty()) {
      write_entries(item, indentation + 2, text);
    } else {
      text.append(write_flow(item)).append("\n");
    }
  }
}

void write_block(const YamlNode& node, std::size_t indentation, std::string& text) {
  if (is_short(node)) {
    text.append(indentation, ' ').append(write_flow(node)).append("\n");
    return;
  }
  switch (node.kind) {
    case YamlKind::null:
    case YamlKind::scalar:
      break;
    case YamlKind::mapping:
      text.append(indentation, ' ');
      write_entries(node, indentation, text);
      break;
    case YamlKind::sequence:
      write_items(node, indentation, text);
      break;
  }
}

}  // namespace

std::string write_yaml(const YamlNode& root) {
  std::string text;
  write_block(root, 0, text);
  return text;
}

std::string write_flow(const YamlNode& node) {
  std::string text;
  switch (node.kind) {
    case YamlKind::null:
      return "~";
    case YamlKind::scalar:
      return write_text(node.text);
    case YamlKind::sequence:
      for (const YamlNode& item : node.items) {
        text.append(text.empty() ? "" : ", ").append(write_flow(item));
      }
      return "[" + text + "]";
    case YamlKind::mapping:
      for (const YamlEntry& entry : node.entries) {
        text.append(text.empty() ? "" : ", ");
        text.append(write_text(entry.key)).append(": ").append(write_flow(entry.value));
      }
      return "{" + text + "}";
  }
  return text;
}

}  // namespace maquette::sim
