#include "sim/page/comparison_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/machine/machine_description.hpp"
#include "sim/page/data_url.hpp"
#include "sim/page/page.hpp"
#include "sim/page/page_table.hpp"
#include "sim/page/picture_difference.hpp"
#include "sim/picture/image_file.hpp"
#include "sim/report/compare.hpp"
#include "sim/report/scalar_statistics.hpp"
#include "sim/report/table.hpp"
#include "sim/scene/scene_description.hpp"

namespace maquette::sim {
namespace {

/// A value of every run by its path; those that a run has not are empty.
using ValuesByPath = std::map<std::string, std::vector<std::string>>;

/// "440.36 (-12.3 %)" where both are numbers.
std::string with_change(const std::string& first, const std::string& own) {
  const auto from = number_in(first);
  const auto to = number_in(own);
  constexpr double k_percent = 100;
  return from && to && *from != 0 && *from != *to
             ? fmt::format("{} ({:+.3g} %)", own, k_percent * (*to - *from) / std::abs(*from))
             : own;
}

/// The rows in which a run differs from the first, in the order of `paths`.
Html differences(const std::string& caption, const std::vector<RunResults>& runs,
                 const std::vector<std::string>& paths, const ValuesByPath& values) {
  PageTable table{caption, {{"name"}}, {}};
  table.is_long = true;
  for (const RunResults& run : runs) {
    table.columns.push_back({run.name, true});
  }
  for (const std::string& path : paths) {
    const std::vector<std::string>& own = values.at(path);
    if (std::any_of(own.begin(), own.end(),
                    [&own](const std::string& value) { return value != own.front(); })) {
      table.rows.push_back({path});
      for (const std::string& value : own) {
        table.rows.back().push_back(value.empty() ? "absent" : with_change(own.front(), value));
      }
    }
  }
  return table.rows.empty() ? paragraph("Nothing differs.") : table_element(table);
}

/// Gathers values run by run; `list` gives those of one as pairs of path and value.
template <class List>
Html differing(const std::string& caption, const std::vector<RunResults>& runs, List list) {
  std::vector<std::string> paths;
  ValuesByPath values;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (auto& [path, value] : list(runs[run])) {
      const auto [place, is_new] = values.try_emplace(path, runs.size());
      if (is_new) {
        paths.push_back(path);
      }
      place->second[run] = value;
    }
  }
  return differences(caption, runs, paths, values);
}

FlatValues statistics_of(const RunResults& run) {
  FlatValues values;
  for (const ScalarStatistic& statistic : scalar_statistics(run.statistics)) {
    values.emplace_back(
        statistic.name +
            (statistic.unit.empty() || statistic.unit == "1" ? "" : " [" + statistic.unit + "]"),
        statistic.text);
  }
  return values;
}

FlatValues configuration_of(const RunResults& run) {
  FlatValues values;
  for (const ParameterRow& row : list_parameters(run.description.machine)) {
    values.emplace_back(row.path, row.value);
  }
  for (const ParameterRow& row : list_parameters(run.description.scene)) {
    values.emplace_back("scene " + row.path, row.value);
  }
  return values;
}

Html picture(const std::string& png, const std::string& caption) {
  return element("figure",
                 void_element("img", {{"alt", caption}, {"src", data_url("image/png", png)}}) +
                     element("figcaption", caption));
}

Html difference_from(const RunResults& first, const RunResults& second) {
  const models::Picture own = decode_png(second.frame_png, "frame.png");
  const models::Picture base = decode_png(first.frame_png, "frame.png");
  const PictureDifference difference = compare_pictures(base, own);
  const std::string names = second.name + " against " + first.name;
  if (difference.first_size != difference.second_size) {
    return paragraph(names + ": the pictures have different sizes.");
  }
  if (difference.pixels == 0) {
    return paragraph(names + ": the pictures are equal.");
  }
  return picture(
      encode_png(difference_picture(base, own)),
      fmt::format("{}: {} pixels differ, a channel by at most {} of 255; bright where they do",
                  names, difference.pixels,
                  *std::max_element(difference.largest.begin(), difference.largest.end())));
}

Html pictures_of(const std::vector<RunResults>& runs) {
  Html strip;
  Html differences;
  for (const RunResults& run : runs) {
    strip += picture(run.frame_png, run.name);
    if (&run != &runs.front()) {
      differences += difference_from(runs.front(), run);
    }
  }
  return element("div", {{"class", "strip"}}, strip) + differences;
}

}  // namespace

std::string comparison_page(const std::vector<RunResults>& runs) {
  std::string names;
  for (const RunResults& run : runs) {
    names += (names.empty() ? "" : ", ") + run.name;
  }
  return page("Compared: " + names,
              {{"pictures", "Pictures", pictures_of(runs)},
               {"configuration", "Configuration",
                differing("Parameters that differ", runs, configuration_of)},
               {"statistics", "Statistics",
                differing("Statistics that differ, and by how much from the first run", runs,
                          statistics_of)}});
}

}  // namespace maquette::sim
