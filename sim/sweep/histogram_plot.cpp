#include "sim/sweep/histogram_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/plot/gnuplot.hpp"
#include "sim/report/quantile.hpp"
#include "sim/sweep/point_list.hpp"

namespace maquette::sim {
namespace {

constexpr int k_fewest_bins = 5;
constexpr int k_most_bins = 60;

/// The results of the points that vary something, the smallest first.
std::vector<double> sorted_results(const Plot& plot, const PlotData& data) {
  std::vector<double> results;
  for (std::size_t row = 0; row < data.table.rows.size(); ++row) {
    const bool is_plain = static_cast<int>(row) == plain_point(data.study.design);
    const std::optional<double> result = number_at(data, row, plot.y);
    if (result && !is_plain) {
      results.push_back(*result);
    }
  }
  std::sort(results.begin(), results.end());
  return results;
}

/// Rows of middle, number of results and width, for about the square root of their number of bins.
std::vector<std::vector<double>> bins_of(const std::vector<double>& results) {
  const double first = results.front();
  const int count =
      std::clamp(static_cast<int>(std::sqrt(results.size())), k_fewest_bins, k_most_bins);
  const double width = std::max((results.back() - first) / count, std::abs(first) * 1e-9);
  std::vector<std::vector<double>> bins;
  bins.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    bins.push_back({first + (i + 0.5) * width, 0, width});
  }
  for (const double result : results) {
    const double place = width > 0 ? (result - first) / width : 0;
    bins[static_cast<std::size_t>(std::min(static_cast<int>(place), count - 1))][1] += 1;
  }
  return bins;
}

std::string upright(double place, const char* style) {
  return fmt::format("set arrow from {0}, graph 0 to {0}, graph 1 nohead front {1}\n", place,
                     style);
}

}  // namespace

std::string histogram_script(const Plot& plot, const PlotData& data) {
  const std::vector<double> results = sorted_results(plot, data);
  if (results.empty()) {
    return gnuplot_script(file_name_of(plot), title_settings(plot, data), "plot NaN notitle");
  }
  const double low = quantile(results, 0.05);
  const double middle = quantile(results, 0.5);
  const double high = quantile(results, 0.95);
  std::string settings = title_settings(plot, data);
  settings += "set xlabel " + axis_label(data, plot.y, 110) + "\n";
  settings +=
      fmt::format("set ylabel {}\n", gnuplot_text(fmt::format("points, of {}", results.size())));
  settings += "set yrange [0:*]\nset offsets 0, 0, graph 0.08, 0\n";
  settings += "set grid noxtics ytics\nset style fill solid 0.85 border rgb 'white'\n";
  settings += "set bmargin 6\nset key horizontal center bottom at screen 0.5, 0.02\n";
  settings += fmt::format(
      "set object rectangle from {}, graph 0 to {}, graph 1 behind fillcolor rgb '#FCE5CD' "
      "fillstyle solid 1 noborder\n",
      low, high);
  settings += upright(middle, "linecolor rgb '#D55E00' linewidth 2");
  settings += gnuplot_data("bins", bins_of(results));
  std::string curves = "plot $bins using 1:2:3 with boxes linetype 1 notitle";
  curves += ", NaN with boxes fillcolor rgb '#FCE5CD' title " +
            gnuplot_text(fmt::format("90 % within {} to {}", gnuplot_number(low),
                                     with_unit_of(data, plot.y, high)));
  curves += ", NaN with lines linecolor rgb '#D55E00' linewidth 2 title " +
            gnuplot_text("median " + with_unit_of(data, plot.y, middle));
  if (const int plain = plain_point(data.study.design); plain >= 0) {
    const double base = number_at(data, static_cast<std::size_t>(plain), plot.y).value_or(middle);
    settings += upright(base, "linecolor rgb 'black' linewidth 2 dashtype 2");
    curves += ", NaN with lines linecolor rgb 'black' linewidth 2 dashtype 2 title " +
              gnuplot_text("as described: " + with_unit_of(data, plot.y, base));
  }
  return gnuplot_script(file_name_of(plot), settings, curves);
}

}  // namespace maquette::sim
