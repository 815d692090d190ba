#pragma once

#include <optional>
#include <string>
#include <vector>

namespace maquette::sim {

struct TableColumn {
  std::string name;
  std::string unit;      ///< "" for none
  std::string sentence;  ///< what it is, for people; "" when nobody has said
};

/// One row per point of a study, in their order; cells are texts, empty where there is nothing.
struct Table {
  std::vector<TableColumn> columns;
  std::vector<std::vector<std::string>> rows;

  /// The number of the column with this name; nothing when there is none.
  [[nodiscard]] std::optional<std::size_t> find(const std::string& name) const;
};

/// "frame.time_s [s]".
[[nodiscard]] std::string heading_of(const TableColumn& column);

/// The table as comma-separated values (RFC 4180, lines end in a line feed), headings first.
[[nodiscard]] std::string table_csv(const Table& table);

/// The number in a cell; nothing when it holds none.
[[nodiscard]] std::optional<double> number_in(const std::string& cell);

}  // namespace maquette::sim
