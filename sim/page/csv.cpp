#include "sim/page/csv.hpp"

#include <algorithm>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

/// The cell that begins at a place in the text, which goes to what ends it.
std::string take_cell(const std::string& text, std::size_t& at, const SourcePosition& position) {
  if (at >= text.size() || text[at] != '"') {
    const std::size_t end = std::min(text.find_first_of(",\n", at), text.size());
    std::string cell = text.substr(at, end - at);
    at = end;
    return cell;
  }
  std::string cell;
  for (++at; at < text.size(); ++at) {
    if (text[at] != '"') {
      cell += text[at];
    } else if (at + 1 < text.size() && text[at + 1] == '"') {
      cell += text[++at];
    } else {
      ++at;
      return cell;
    }
  }
  throw DescriptionError(position, "a quotation has no end; allowed: a table that maquette wrote");
}

}  // namespace

std::vector<std::vector<std::string>> parse_csv(const std::string& text, const std::string& name) {
  std::vector<std::vector<std::string>> lines;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const SourcePosition position{name, static_cast<int>(lines.size()) + 1, 1};
    lines.emplace_back();
    do {
      at += lines.back().empty() ? 0 : 1;
      lines.back().push_back(take_cell(text, at, position));
    } while (at < text.size() && text[at] == ',');
    if (lines.back().size() != lines.front().size() || (at < text.size() && text[at] != '\n')) {
      throw DescriptionError(position,
                             "this line is no row of the table; allowed: as many cells as "
                             "there are headings");
    }
  }
  return lines;
}

}  // namespace maquette::sim
