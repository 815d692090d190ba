#include "sim/page/html.hpp"

#include <algorithm>
#include <array>

namespace maquette::sim {
namespace {

constexpr std::string_view k_replacement = "\xEF\xBF\xBD";

/// Bytes of the UTF-8 character at the beginning; 0 where there is none.
std::size_t character_length(std::string_view text) {
  struct Form {
    unsigned char mask, lead;
    std::size_t length;
  };
  constexpr std::array<Form, 4> k_forms{
      {{0x80, 0x00, 1}, {0xE0, 0xC0, 2}, {0xF0, 0xE0, 3}, {0xF8, 0xF0, 4}}};
  const auto lead = static_cast<unsigned char>(text.front());
  for (const Form& form : k_forms) {
    if ((lead & form.mask) == form.lead) {
      const std::string_view rest = text.substr(1, form.length - 1);
      const bool is_whole =
          rest.size() == form.length - 1 && std::all_of(rest.begin(), rest.end(), [](char byte) {
            return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
          });
      return is_whole ? form.length : 0;
    }
  }
  return 0;
}

bool is_forbidden_control(char byte) {
  const auto code = static_cast<unsigned char>(byte);
  return code == 0x7F || (code < 0x20 && byte != '\n' && byte != '\t');
}

std::string escaped(std::string_view plain) {
  std::string markup;
  markup.reserve(plain.size());
  while (!plain.empty()) {
    const std::size_t length = character_length(plain);
    const char first = plain.front();
    if (length == 0 || is_forbidden_control(first)) {
      markup += k_replacement;
    } else if (first == '<') {
      markup += "&lt;";
    } else if (first == '>') {
      markup += "&gt;";
    } else if (first == '&') {
      markup += "&amp;";
    } else if (first == '"') {
      markup += "&quot;";
    } else {
      markup += plain.substr(0, length);
    }
    plain.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return markup;
}

std::string opened(std::string_view name, const Attributes& attributes) {
  std::string markup = "<";
  markup += name;
  for (const auto& [key, value] : attributes) {
    markup += ' ';
    markup += key;
    markup += "=\"" + escaped(value) + '"';
  }
  return markup;
}

}  // namespace

Html text(std::string_view plain) { return {escaped(plain)}; }

Html element(std::string_view name, const Attributes& attributes, const Html& content) {
  Html whole{opened(name, attributes)};
  whole.markup += '>' + content.markup + "</";
  whole.markup += name;
  whole.markup += ">\n";
  return whole;
}

Html element(std::string_view name, const Html& content) { return element(name, {}, content); }

Html element(std::string_view name, std::string_view plain) { return element(name, text(plain)); }

Html void_element(std::string_view name, const Attributes& attributes) {
  return {opened(name, attributes) + "/>"};
}

Html paragraph(std::string_view plain) { return element("p", plain); }

Html data_element(const std::string& id, std::string_view json) {
  std::string safe;
  safe.reserve(json.size());
  for (const char byte : json) {
    switch (byte) {
      case '<':
        safe += "\\u003c";
        break;
      case '>':
        safe += "\\u003e";
        break;
      case '&':
        safe += "\\u0026";
        break;
      default:
        safe += byte;
    }
  }
  return element("script", {{"type", "application/json"}, {"id", id}}, Html{safe});
}

Html folded(std::string_view summary, const Html& content) {
  return element("details", element("summary", summary) + content);
}

}  // namespace maquette::sim
