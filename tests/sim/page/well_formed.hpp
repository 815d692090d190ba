#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace maquette::tests {

/// What keeps a page from being well-formed XML, as far as tags, attributes and entities go; empty
/// where nothing does.
inline std::string ill_formed(std::string_view page) {
  constexpr std::string_view k_doctype = "<!DOCTYPE html>\n";
  if (page.substr(0, k_doctype.size()) == k_doctype) {
    page.remove_prefix(k_doctype.size());
  }
  std::vector<std::string> open;
  for (std::size_t at = page.find_first_of("<&"); at != std::string_view::npos;
       at = page.find_first_of("<&", at + 1)) {
    const std::string_view rest = page.substr(at);
    if (rest.front() == '&') {
      const std::string_view entity = rest.substr(0, rest.find(';') + 1);
      if (entity != "&lt;" && entity != "&gt;" && entity != "&amp;" && entity != "&quot;") {
        return "a bare & before " + std::string(rest.substr(0, 20));
      }
      continue;
    }
    const std::size_t end = rest.find('>');
    if (end == std::string_view::npos || rest.find('<', 1) < end) {
      return "an open tag " + std::string(rest.substr(0, 40));
    }
    const std::string_view tag = rest.substr(1, end - 1);
    const std::string name(tag.substr(0, tag.find_first_of(" /", 1)));
    if (tag.front() == '/') {
      if (open.empty() || "/" + open.back() != tag) {
        return std::string(tag) + " closes what is not open";
      }
      open.pop_back();
    } else if (tag.back() != '/') {
      open.push_back(name);
    }
  }
  return open.empty() ? "" : open.back() + " is not closed";
}

}  // namespace maquette::tests
