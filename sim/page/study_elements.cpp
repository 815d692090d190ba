#include "sim/page/study_elements.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "sim/page/csv.hpp"
#include "sim/page/data_url.hpp"
#include "sim/page/page_table.hpp"
#include "sim/report/run_directory.hpp"
#include "sim/report/table.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

std::string study_name(const fs::path& directory) {
  const fs::path path = directory.lexically_normal();
  return (path.has_filename() ? path : path.parent_path()).filename().string();
}

Html csv_element(const std::string& caption, const fs::path& file, bool is_parallel) {
  std::vector<std::vector<std::string>> lines = parse_csv(read_file(file), file.string());
  if (lines.empty()) {
    return paragraph(caption + ": none.");
  }
  PageTable table{caption, {}, {lines.begin() + 1, lines.end()}};
  table.is_long = true;
  table.is_plotted = true;
  table.is_parallel = is_parallel;
  for (std::size_t column = 0; column < lines.front().size(); ++column) {
    const bool is_number = std::all_of(
        table.rows.begin(), table.rows.end(),
        [column](const auto& row) { return row[column].empty() || number_in(row[column]); });
    table.columns.push_back({lines.front()[column], is_number});
  }
  return paragraph(fmt::format("{} rows, {} columns.", table.rows.size(), table.columns.size())) +
         table_element(table);
}

std::vector<Section> with_plots(std::vector<Section> sections,
                                const std::vector<fs::path>& folders) {
  Html pictures;
  for (const fs::path& folder : folders) {
    pictures += pictures_in(folder);
  }
  if (!pictures.markup.empty()) {
    sections.push_back({"plots", "Plots", pictures});
  }
  return sections;
}

}  // namespace maquette::sim
