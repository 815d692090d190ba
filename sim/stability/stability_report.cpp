#include "sim/stability/stability_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace maquette::sim {

namespace {

using Measurements = std::vector<StabilityMeasurement>;

/// Counts in full, other figures with three digits.
std::string number_text(double value) {
  const bool is_count = value == std::floor(value) && std::fabs(value) < 1e9;
  return is_count ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

bool is_same(const StabilityRow& a, const StabilityRow& b) {
  return a.group == b.group && a.subject == b.subject && a.counted == b.counted;
}

std::string cells_of(const StabilityRow& row, const StabilityMeasurement& measurement) {
  const auto found =
      std::find_if(measurement.rows.begin(), measurement.rows.end(),
                   [&row](const StabilityRow& other) { return is_same(row, other); });
  if (found == measurement.rows.end()) {
    return fmt::format("{:>12}{:>10}", "", "");
  }
  const std::string mark = found->holds() ? "" : "! ";
  return fmt::format("{:>12}{:>10}", mark + number_text(found->value),
                     found->bound ? number_text(*found->bound) : "");
}

}  // namespace

int broken_bounds(const Measurements& measurements) {
  int broken = 0;
  for (const StabilityMeasurement& measurement : measurements) {
    for (const StabilityRow& row : measurement.rows) {
      broken += row.holds() ? 0 : 1;
    }
  }
  return broken;
}

std::string stability_table(const Measurements& measurements) {
  if (measurements.empty()) {
    return "";
  }
  std::size_t subject_width = 0;
  std::size_t counted_width = 0;
  for (const StabilityRow& row : measurements.front().rows) {
    subject_width = std::max(subject_width, row.subject.size());
    counted_width = std::max(counted_width, row.counted.size());
  }
  std::string text = std::string(subject_width + counted_width + 4, ' ');
  for (const StabilityMeasurement& measurement : measurements) {
    text += fmt::format("{:>12}{:>10}", measurement.scalar, "at most");
  }
  std::string group;
  for (const StabilityRow& row : measurements.front().rows) {
    text += row.group == group ? "\n" : "\n" + row.group + "\n";
    group = row.group;
    text += fmt::format("  {:<{}}  {:<{}}", row.subject, subject_width, row.counted, counted_width);
    for (const StabilityMeasurement& measurement : measurements) {
      text += cells_of(row, measurement);
    }
  }
  return text + "\n";
}

std::string stability_json(const Measurements& measurements) {
  using Json = nlohmann::ordered_json;
  Json rows = Json::array();
  for (const StabilityMeasurement& measurement : measurements) {
    for (const StabilityRow& row : measurement.rows) {
      rows.push_back(Json{{"scalar", measurement.scalar},
                          {"group", row.group},
                          {"case", row.subject},
                          {"counted", row.counted},
                          {"value", row.value},
                          {"bound", row.bound ? Json(*row.bound) : Json(nullptr)},
                          {"holds", row.holds()}});
    }
  }
  const int broken = broken_bounds(measurements);
  return Json{{"rows", rows}, {"broken_bounds", broken}}.dump(2) + "\n";
}

}  // namespace maquette::sim
