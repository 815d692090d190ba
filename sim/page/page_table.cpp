#include "sim/page/page_table.hpp"

#include <fmt/format.h>

namespace maquette::sim {
namespace {

Attributes with_class(Attributes attributes, bool is_number) {
  if (is_number) {
    attributes.emplace_back("class", "number");
  }
  return attributes;
}

Html head_of(const PageTable& table) {
  Html cells;
  for (const PageColumn& column : table.columns) {
    cells += element("th", with_class({{"scope", "col"}}, column.is_number), text(column.heading));
  }
  return element("thead", element("tr", cells));
}

Attributes shade_of(const PageTable& table, std::size_t row, std::size_t column) {
  return table.shades.empty()
             ? Attributes{}
             : Attributes{{"style", fmt::format("--shade:{:.3f}", table.shades[row][column - 1])}};
}

Html body_of(const PageTable& table) {
  Html rows;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    Html cells;
    for (std::size_t i = 0; i < table.rows[row].size(); ++i) {
      const bool is_number = i < table.columns.size() && table.columns[i].is_number;
      const Attributes own = i == 0 ? Attributes{{"scope", "row"}} : shade_of(table, row, i);
      cells += element(i == 0 ? "th" : "td", with_class(own, is_number), text(table.rows[row][i]));
    }
    rows += element("tr", cells);
  }
  return element("tbody", rows);
}

}  // namespace

Html table_element(const PageTable& table) {
  const Html whole =
      element("table",
              {{"class", std::string("sortable") + (table.is_long ? " filterable" : "") +
                             (table.is_plotted ? " plotted" : "") +
                             (table.is_parallel ? " parallel" : "")}},
              element("caption", table.caption) + head_of(table) + body_of(table));
  return element(
      "div",
      {{"class", "wide"}, {"role", "region"}, {"tabindex", "0"}, {"aria-label", table.caption}},
      whole);
}

Html definitions(const std::vector<std::pair<std::string, std::string>>& rows) {
  Html list;
  for (const auto& [term, meaning] : rows) {
    list += element("dt", term) + element("dd", meaning);
  }
  return element("dl", list);
}

}  // namespace maquette::sim
