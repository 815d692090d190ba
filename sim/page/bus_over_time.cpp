#include "sim/page/bus_over_time.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/page/chart.hpp"
#include "sim/page/page_table.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_parts = 120;

const std::vector<double>* values_of(const ReadMaps& maps, const std::string& name) {
  const auto place = std::find_if(maps.maps.begin(), maps.maps.end(),
                                  [&name](const ReadMap& read) { return read.map->name == name; });
  return place == maps.maps.end() ? nullptr : &place->values;
}

/// The sum of times of pixels in each part of the frame, over the length of a part.
std::vector<double> over_parts(const std::vector<double>& written, const std::vector<double>& times,
                               double part_s) {
  std::vector<double> sums(k_parts, 0);
  for (std::size_t pixel = 0; pixel < written.size(); ++pixel) {
    if (std::isfinite(written[pixel]) && std::isfinite(times[pixel])) {
      const auto part = static_cast<std::size_t>(std::max(written[pixel], 0.0) / part_s);
      sums[std::min(part, k_parts - 1)] += times[pixel] / part_s;
    }
  }
  return sums;
}

ChartSeries series_of(const std::string& name, const std::vector<double>& values, double part_s) {
  ChartSeries series{name};
  for (std::size_t part = 0; part < values.size(); ++part) {
    series.points.push_back({(static_cast<double>(part) + 0.5) * part_s, values[part], name});
  }
  return series;
}

}  // namespace

Html bus_over_time(const RunResults& results) {
  const std::vector<double>* written = values_of(results.maps, "written");
  const std::vector<double>* transfer = values_of(results.maps, "transfer");
  const std::vector<double>* wait = values_of(results.maps, "wait");
  const double part_s = in_seconds(results.statistics.frame.time) / k_parts;
  if (written == nullptr || transfer == nullptr || wait == nullptr || part_s <= 0) {
    return {};
  }
  const std::vector<double> used = over_parts(*written, *transfer, part_s);
  const std::vector<double> waited = over_parts(*written, *wait, part_s);
  Chart chart{"bus-time-chart",          "Use of the bus and requests waiting, over the frame",
              "The table below has it.", ChartKind::lines,
              "s of the frame",          "mean"};
  chart.series = {series_of("masters of the bus", used, part_s),
                  series_of("requests waiting", waited, part_s)};
  PageTable table{"Means over parts of the frame; what a pixel took counts where it was written",
                  {{"from s", true}, {"masters of the bus", true}, {"requests waiting", true}},
                  {}};
  for (std::size_t part = 0; part < k_parts; ++part) {
    table.rows.push_back({fmt::format("{:.4f}", static_cast<double>(part) * part_s),
                          fmt::format("{:.3g}", used[part]), fmt::format("{:.3g}", waited[part])});
  }
  return chart_element(chart) + folded("These means as a table", table_element(table));
}

}  // namespace maquette::sim
