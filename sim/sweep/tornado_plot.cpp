#include "sim/sweep/tornado_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/plot/gnuplot.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_most_bars = 20;

/// One end of a bar: the result, and the value of the axis that gives it.
struct End {
  double result = 0;
  std::string value;
};

struct Bar {
  std::string axis;
  End least;
  End greatest;

  [[nodiscard]] double length() const { return greatest.result - least.result; }
};

/// The bars of all axes, the longest first. Point 0 is the description itself, and the values of
/// each axis follow it in the order of the axes.
std::vector<Bar> bars_of(const Plot& plot, const PlotData& data, double base) {
  std::vector<Bar> bars;
  for (const Axis& axis : data.study.axes) {
    const TableColumn& column = data.table.columns[data.table.find(axis.path).value()];
    Bar bar{axis.path, {base, ""}, {base, ""}};
    for (std::size_t row = 1; row < data.table.rows.size(); ++row) {
      const std::optional<double> result = number_at(data, row, plot.y);
      const std::string& value = data.table.rows[row][data.table.find(axis.path).value()];
      if (!result || value == data.table.rows[0][data.table.find(axis.path).value()]) {
        continue;
      }
      const std::string text = value + (column.unit.empty() ? "" : " " + column.unit);
      if (*result < bar.least.result) {
        bar.least = {*result, text};
      }
      if (*result > bar.greatest.result) {
        bar.greatest = {*result, text};
      }
    }
    bars.push_back(bar);
  }
  std::stable_sort(bars.begin(), bars.end(), [](const Bar& first, const Bar& second) {
    return first.length() > second.length();
  });
  bars.resize(std::min(bars.size(), k_most_bars));
  return bars;
}

std::string label(const End& end, std::size_t place, const char* side, int offset) {
  return end.value.empty() ? ""
                           : fmt::format("set label {} at {}, {} {} offset character {}, 0 front\n",
                                         gnuplot_text(end.value), end.result, place, side, offset);
}

std::string settings_of(const Plot& plot, const PlotData& data, const std::vector<Bar>& bars,
                        double base) {
  double least = base;
  double greatest = base;
  std::string tics;
  std::string text = title_settings(plot, data);
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const std::size_t place = bars.size() - i;
    least = std::min(least, bars[i].least.result);
    greatest = std::max(greatest, bars[i].greatest.result);
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_text(bars[i].axis), place);
    text += label(bars[i].least, place, "right", -1) + label(bars[i].greatest, place, "left", 1);
  }
  const double width = std::max(greatest - least, std::abs(base) * 1e-6);
  text += "set xlabel " + axis_label(data, plot.y, 110) + "\n";
  text += fmt::format("set ytics ({})\nset yrange [0.3:{}]\nset xrange [{}:{}]\n", tics,
                      static_cast<double>(bars.size()) + 0.7, least - 0.2 * width,
                      greatest + 0.2 * width);
  text += "set grid noytics xtics\nset style fill solid 0.85 noborder\n";
  text += "set bmargin 6\nset key horizontal center bottom at screen 0.5, 0.02\n";
  return text;
}

}  // namespace

std::string tornado_script(const Plot& plot, const PlotData& data) {
  const double base = number_at(data, 0, plot.y).value_or(0);
  const std::vector<Bar> bars = bars_of(plot, data, base);
  std::vector<std::vector<double>> below;
  std::vector<std::vector<double>> above;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    const auto place = static_cast<double>(bars.size() - i);
    below.push_back({bars[i].least.result, base, place - 0.35, place + 0.35});
    above.push_back({base, bars[i].greatest.result, place - 0.35, place + 0.35});
  }
  const std::string settings =
      settings_of(plot, data, bars, base) + gnuplot_data("below", below) +
      gnuplot_data("above", above) +
      gnuplot_data("base", std::vector<PlotPoint>{{base, 0.3},
                                                  {base, static_cast<double>(bars.size()) + 0.7}});
  return gnuplot_script(
      file_name_of(plot), settings,
      fmt::format("plot $below using 1:3:1:2:3:4 with boxxyerror linetype 1 title 'less', "
                  "$above using 1:3:1:2:3:4 with boxxyerror linetype 2 title 'more', "
                  "$base using 1:2 with lines linecolor rgb 'black' linewidth 2 title {}",
                  gnuplot_text("as described: " + with_unit_of(data, plot.y, base))));
}

}  // namespace maquette::sim
