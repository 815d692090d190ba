#include "sim/sweep/scatter_plot.hpp"

#include <fmt/format.h>

#include "sim/plot/gnuplot.hpp"
#include "sim/sweep/point_list.hpp"

namespace maquette::sim {
namespace {

struct Points {
  std::vector<PlotPoint> inside;
  std::vector<PlotPoint> outside;
  std::vector<PlotPoint> plain;
};

Points points_of(const Plot& plot, const PlotData& data) {
  Points points;
  for (std::size_t row = 0; row < data.table.rows.size(); ++row) {
    const std::optional<double> x = number_at(data, row, plot.x);
    const std::optional<double> y = number_at(data, row, plot.y);
    if (!x || !y) {
      continue;
    }
    if (static_cast<int>(row) == plain_point(data.study.design)) {
      points.plain.push_back({*x, *y});
      continue;
    }
    const std::optional<double> band =
        plot.band.empty() ? std::nullopt : number_at(data, row, plot.band);
    const bool is_inside = band && *band >= plot.band_low && *band <= plot.band_high;
    (is_inside ? points.inside : points.outside).push_back({*x, *y});
  }
  return points;
}

}  // namespace

std::string scatter_script(const Plot& plot, const PlotData& data) {
  const Points points = points_of(plot, data);
  std::string settings = title_settings(plot, data);
  settings += "set xlabel " + axis_label(data, plot.x, 110) + "\n";
  settings += "set ylabel " + axis_label(data, plot.y, 60) + "\n";
  settings += plot.log_x ? "set logscale x\n" : "";
  settings += plot.log_y ? "set logscale y\n" : "";
  settings += "set bmargin 8\nset key horizontal center bottom at screen 0.5, 0.02\n";
  settings += "set autoscale fix\nset offsets graph 0.02, graph 0.02, graph 0.02, graph 0.02\n";
  std::string curves;
  const auto add = [&](const char* name, const std::vector<PlotPoint>& shown,
                       const std::string& style) {
    if (!shown.empty()) {
      settings += gnuplot_data(name, shown);
      curves += fmt::format("{}${} using 1:2 with points {}", curves.empty() ? "plot " : ", ", name,
                            style);
    }
  };
  const std::string inside =
      plot.band.empty()
          ? ""
          : fmt::format("{} within {} to {}: {} of {} points", plot.band,
                        gnuplot_number(plot.band_low),
                        with_unit_of(data, plot.band, plot.band_high), points.inside.size(),
                        points.inside.size() + points.outside.size());
  add("outside", points.outside,
      plot.band.empty() ? "linetype 1 pointsize 1 notitle"
                        : "pointtype 7 pointsize 1 linecolor rgb '#BBBBBB' title 'others'");
  add("inside", points.inside,
      "pointtype 7 pointsize 1.2 linecolor rgb '#D55E00' title " + gnuplot_text(inside));
  add("plain", points.plain,
      "pointtype 6 pointsize 3 linewidth 3 linecolor rgb 'black' title 'as described'");
  return gnuplot_script(file_name_of(plot), settings, curves.empty() ? "plot NaN notitle" : curves);
}

}  // namespace maquette::sim
