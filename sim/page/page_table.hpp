#pragma once

#include <string>
#include <vector>

#include "sim/page/html.hpp"

namespace maquette::sim {

/// A column of a table on a page; numbers stand to the right.
struct PageColumn {
  std::string heading;  ///< with its unit
  bool is_number = false;
};

/// A table on a page. Cells are plain texts; the first of a row is its heading.
struct PageTable {
  std::string caption;
  std::vector<PageColumn> columns;
  std::vector<std::vector<std::string>> rows;
  bool is_long = false;     ///< can be filtered, where scripts run
  bool is_plotted = false;  ///< columns can be plotted over each other there
  /// Of each cell behind the first of its row, how deep its ground is coloured: 0 to 1. May be
  /// empty.
  std::vector<std::vector<double>> shades = {};
  bool is_parallel = false;  ///< all columns side by side as well, as parallel coordinates
};

/// A table that scrolls within the page where it is wider, and that scripts can sort.
[[nodiscard]] Html table_element(const PageTable& table);

/// A list of terms and what they are.
[[nodiscard]] Html definitions(const std::vector<std::pair<std::string, std::string>>& rows);

}  // namespace maquette::sim
