#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace maquette::sim {

/// Markup that is complete in itself: well-formed as HTML and as XML. Texts become markup by `text`
/// alone, which is the one place where they are escaped.
struct Html {
  std::string markup;

  Html& operator+=(const Html& other) {
    markup += other.markup;
    return *this;
  }
};

[[nodiscard]] inline Html operator+(Html first, const Html& second) { return first += second; }

/// Names and values of attributes; the values are plain texts.
using Attributes = std::vector<std::pair<std::string_view, std::string>>;

/// A plain text as markup: nothing in it is taken for a tag. Control characters that no page may
/// hold become U+FFFD, and so do bytes that are not UTF-8.
[[nodiscard]] Html text(std::string_view plain);

/// <name ...>content</name>.
[[nodiscard]] Html element(std::string_view name, const Attributes& attributes,
                           const Html& content);
[[nodiscard]] Html element(std::string_view name, const Html& content);
[[nodiscard]] Html element(std::string_view name, std::string_view plain);

/// <name .../>, of an element that never has content.
[[nodiscard]] Html void_element(std::string_view name, const Attributes& attributes);

/// A paragraph of plain text.
[[nodiscard]] Html paragraph(std::string_view plain);

/// JSON within a script element that no browser runs; `json` is the text, in which what could end
/// the element is written as \uXXXX.
[[nodiscard]] Html data_element(const std::string& id, std::string_view json);

/// A part that can be unfolded, folded at first.
[[nodiscard]] Html folded(std::string_view summary, const Html& content);

}  // namespace maquette::sim
