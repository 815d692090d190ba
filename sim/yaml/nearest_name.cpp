#include "sim/yaml/nearest_name.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace maquette::sim {
namespace {

/// Longer names are no slips of the pen.
constexpr std::size_t k_longest_name = 64;

/// Names listed in a message before it says "and N more".
constexpr std::size_t k_listed_names = 40;

std::string list_names(const std::vector<std::string_view>& names) {
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), k_listed_names); ++i) {
    list.append(i == 0 ? "" : ", ").append(names[i]);
  }
  if (names.size() > k_listed_names) {
    list += " and " + std::to_string(names.size() - k_listed_names) + " more";
  }
  return list;
}

}  // namespace

int edit_distance(std::string_view left, std::string_view right) {
  using Row = std::vector<int>;
  std::array<Row, 3> rows;  // the last three, the oldest first
  rows.fill(Row(right.size() + 1));
  for (std::size_t j = 0; j <= right.size(); ++j) {
    rows[2][j] = static_cast<int>(j);
  }
  for (std::size_t i = 1; i <= left.size(); ++i) {
    std::rotate(rows.begin(), rows.begin() + 1, rows.end());
    Row& row = rows[2];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= right.size(); ++j) {
      const int replaced = rows[1][j - 1] + (left[i - 1] == right[j - 1] ? 0 : 1);
      row[j] = std::min({rows[1][j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && left[i - 1] == right[j - 2] && left[i - 2] == right[j - 1]) {
        row[j] = std::min(row[j], rows[0][j - 2] + 1);
      }
    }
  }
  return rows[2][right.size()];
}

std::string allowed_names(std::string_view name, const std::vector<std::string_view>& allowed) {
  if (allowed.empty()) {
    return "none is allowed here";
  }
  std::string message = "allowed: " + list_names(allowed);
  if (name.size() > k_longest_name) {
    return message;
  }
  std::string_view nearest;
  int least = static_cast<int>(std::max<std::size_t>(name.size() / 3, 1)) + 1;
  for (const std::string_view candidate : allowed) {
    const int distance = candidate.size() > k_longest_name ? least : edit_distance(name, candidate);
    if (distance < least) {
      least = distance;
      nearest = candidate;
    }
  }
  if (!nearest.empty()) {
    message.append("; did you mean `").append(nearest).append("`?");
  }
  return message;
}

}  // namespace maquette::sim
