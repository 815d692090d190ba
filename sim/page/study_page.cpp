#include "sim/page/study_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "sim/page/csv.hpp"
#include "sim/page/data_url.hpp"
#include "sim/page/figures.hpp"
#include "sim/page/page.hpp"
#include "sim/page/page_table.hpp"
#include "sim/report/flat_json.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/report/table.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

std::string name_of(const fs::path& directory) {
  const fs::path path = directory.lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

/// The table of a CSV file; a column of numbers is one in which no cell is another text.
Html csv_element(const std::string& caption, const fs::path& file) {
  std::vector<std::vector<std::string>> lines = parse_csv(read_file(file), file.string());
  if (lines.empty()) {
    return paragraph(caption + ": none.");
  }
  PageTable table{caption, {}, {lines.begin() + 1, lines.end()}};
  table.is_long = true;
  table.is_plotted = true;
  for (std::size_t column = 0; column < lines.front().size(); ++column) {
    const bool is_number = std::all_of(
        table.rows.begin(), table.rows.end(),
        [column](const auto& row) { return row[column].empty() || number_in(row[column]); });
    table.columns.push_back({lines.front()[column], is_number});
  }
  return paragraph(fmt::format("{} rows, {} columns.", table.rows.size(), table.columns.size())) +
         table_element(table);
}

/// The PNG files of a folder, in the order of their names.
Html pictures_in(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".png" && entry.is_regular_file()) {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  Html pictures;
  for (const fs::path& file : files) {
    const std::string name = file.stem().string();
    pictures += element(
        "figure",
        void_element("img", {{"alt", name}, {"src", data_url("image/png", read_file(file))}}) +
            element("figcaption", name));
  }
  return pictures;
}

std::vector<Section> with_pictures(std::vector<Section> sections, const Html& pictures) {
  if (!pictures.markup.empty()) {
    sections.push_back({"plots", "Plots", pictures});
  }
  return sections;
}

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

std::string sweep_page(const fs::path& directory) {
  return page(name_of(directory) + ": a sweep",
              with_pictures({{"points", "Points",
                              csv_element("Points of the sweep", directory / "table.csv")}},
                            pictures_in(directory / "plots")));
}

std::string accuracy_page(const fs::path& directory) {
  return page(
      name_of(directory) + ": error against run time",
      with_pictures(
          {{"errors", "Errors", csv_element("Errors of every level", directory / "accuracy.csv")},
           {"times", "Times of the host",
            csv_element("What every level costs the host", directory / "host_times.csv")}},
          pictures_in(directory) + pictures_in(directory / "plots")));
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
  return page(name_of(directory) + ": stability", {{"bounds", "Bounds", table_element(table)}});
}

}  // namespace maquette::sim
