#include "sim/page/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim/page/figures.hpp"
#include "sim/page/page.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/study_elements.hpp"
#include "sim/report/flat_json.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

/// A value of stability and its bound, and the share of the bound that it takes; 2 where it is
/// broken.
struct BoundRow {
  std::vector<std::string> cells;
  double nearness = 0;
};

BoundRow bound_row(const nlohmann::json& row) {
  const nlohmann::json& bound = row.at("bound");
  const bool holds = row.at("holds").get<bool>();
  const double value = row.at("value").is_number() ? row.at("value").get<double>() : 0;
  const double limit = bound.is_number() ? bound.get<double>() : 0;
  return {{row.at("group").get<std::string>(), row.at("case").get<std::string>(),
           row.at("counted").get<std::string>(), row.at("scalar").get<std::string>(),
           row.at("value").dump(), bound.is_null() ? "" : bound.dump(),
           bound.is_null() ? "only told"
           : holds         ? "holds"
                           : "BROKEN"},
          holds ? share_of(value, limit) : 2};
}

}  // namespace

std::string accuracy_page(const fs::path& directory) {
  return page(
      study_name(directory) + ": error against run time",
      with_plots(
          {{"errors", "Errors", csv_element("Errors of every level", directory / "accuracy.csv")},
           {"times", "Times of the host",
            csv_element("What every level costs the host", directory / "host_times.csv")}},
          {directory, directory / "plots"}));
}

std::string stability_page(const fs::path& directory) {
  const fs::path file = directory / "stability.json";
  const std::string text = read_file(file);
  flatten_json(text, file.string());
  std::vector<BoundRow> rows;
  try {
    const nlohmann::json stability = nlohmann::json::parse(text);
    for (const nlohmann::json& row : stability.at("rows")) {
      rows.push_back(bound_row(row));
    }
  } catch (const nlohmann::json::exception& error) {
    throw DescriptionError(SourcePosition{file.string(), 1, 1},
                           std::string("is no measured stability: ") + error.what() +
                               "; allowed: what `maquette stability` has written");
  }
  std::stable_sort(rows.begin(), rows.end(), [](const BoundRow& first, const BoundRow& second) {
    return first.nearness > second.nearness;
  });
  PageTable table{"Measured values and their bounds, the nearest to breaking first",
                  {{"group"},
                   {"case"},
                   {"counted"},
                   {"numbers"},
                   {"value", true},
                   {"at most", true},
                   {"bound"}},
                  {}};
  table.is_long = true;
  for (const BoundRow& row : rows) {
    table.rows.push_back(row.cells);
  }
  return page(study_name(directory) + ": stability", {{"bounds", "Bounds", table_element(table)}});
}

}  // namespace maquette::sim
