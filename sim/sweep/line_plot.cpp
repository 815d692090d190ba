#include "sim/sweep/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "sim/plot/gnuplot.hpp"

namespace maquette::sim {
namespace {

/// Values along a logarithmic axis that get a tic each; more would touch.
constexpr std::size_t k_most_tics = 16;

struct Series {
  std::string name;
  std::vector<PlotPoint> points;
};

/// The places of texts along an axis; empty where all cells are numbers.
std::vector<std::string> categories_of(const PlotData& data, const std::string& column) {
  const std::size_t place = data.table.find(column).value();
  std::vector<std::string> texts;
  bool has_text = false;
  for (const auto& row : data.table.rows) {
    has_text = has_text || (!row[place].empty() && !number_in(row[place]));
    if (std::find(texts.begin(), texts.end(), row[place]) == texts.end()) {
      texts.push_back(row[place]);
    }
  }
  return has_text ? texts : std::vector<std::string>{};
}

/// The points of a plot in their series, and those of the prototype.
class Collection {
 public:
  Collection(const Plot& plot, const PlotData& data)
      : plot_(plot), data_(data), categories_(categories_of(data, plot.x)) {
    for (std::size_t row = 0; row < data.table.rows.size(); ++row) {
      add(row);
    }
  }

  [[nodiscard]] const std::vector<Series>& series() const { return series_; }
  [[nodiscard]] const std::vector<PlotPoint>& prototypes() const { return prototypes_; }
  [[nodiscard]] const std::vector<std::string>& categories() const { return categories_; }

  [[nodiscard]] std::set<double> places() const {
    std::set<double> places;
    for (const Series& one : series_) {
      for (const PlotPoint& point : one.points) {
        places.insert(point.x);
      }
    }
    return places;
  }

  /// Whether no series has two points at one place.
  [[nodiscard]] bool makes_lines() const {
    return std::all_of(series_.begin(), series_.end(), [](const Series& one) {
      std::set<double> places;
      return std::all_of(one.points.begin(), one.points.end(), [&places](const PlotPoint& point) {
        return places.insert(point.x).second;
      });
    });
  }

  /// Whether an axis from zero on shows the values well.
  [[nodiscard]] bool is_near_zero() const {
    double least = 0;
    double greatest = 0;
    bool is_first = true;
    for (const Series& one : series_) {
      for (const PlotPoint& point : one.points) {
        least = is_first ? point.y : std::min(least, point.y);
        greatest = is_first ? point.y : std::max(greatest, point.y);
        is_first = false;
      }
    }
    return least >= 0 && least < greatest / 2;
  }

 private:
  void add(std::size_t row) {
    const std::optional<double> x = place_of(row);
    const std::optional<double> y = number_at(data_, row, plot_.y);
    if (!x || !y) {
      return;
    }
    const std::string name =
        plot_.series.empty() ? "" : data_.table.rows[row][data_.table.find(plot_.series).value()];
    auto found = std::find_if(series_.begin(), series_.end(),
                              [&name](const Series& one) { return one.name == name; });
    if (found == series_.end()) {
      found = series_.insert(series_.end(), {name, {}});
    }
    found->points.push_back({*x, *y});
    if (data_.prototypes[row]) {
      prototypes_.push_back({*x, *y});
    }
  }

  [[nodiscard]] std::optional<double> place_of(std::size_t row) const {
    if (categories_.empty()) {
      return number_at(data_, row, plot_.x);
    }
    const std::string& text = data_.table.rows[row][data_.table.find(plot_.x).value()];
    const auto found = std::find(categories_.begin(), categories_.end(), text);
    return static_cast<double>(found - categories_.begin());
  }

  const Plot& plot_;
  const PlotData& data_;
  std::vector<std::string> categories_;
  std::vector<Series> series_;
  std::vector<PlotPoint> prototypes_;
};

std::string tics_of(const Collection& points, bool is_logarithmic) {
  std::string tics;
  for (std::size_t i = 0; i < points.categories().size(); ++i) {
    tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_text(points.categories()[i]), i);
  }
  if (!tics.empty()) {
    return fmt::format("set xtics ({})\nset xrange [-0.5:{}]\n", tics,
                       static_cast<double>(points.categories().size()) - 0.5);
  }
  const std::set<double> places = points.places();
  if (!is_logarithmic || places.size() > k_most_tics) {
    return {};
  }
  for (const double place : places) {
    tics += fmt::format("{}{}", tics.empty() ? "" : ", ", gnuplot_number(place));
  }
  return "set xtics (" + tics + ")\n";
}

std::string settings_of(const Plot& plot, const PlotData& data, const Collection& points) {
  std::string text = title_settings(plot, data);
  text += "set xlabel " + axis_label(data, plot.x, 110) + "\n";
  text += "set ylabel " + axis_label(data, plot.y, 60) + "\n";
  text += plot.log_x && points.categories().empty() ? "set logscale x\n" : "";
  text += plot.log_y ? "set logscale y\n" : "";
  text += tics_of(points, plot.log_x);
  text += points.is_near_zero() && !plot.log_y ? "set yrange [0:*]\n" : "";
  text += "set autoscale fix\nset offsets graph 0.03, graph 0.03, graph 0.05, " +
          std::string(plot.log_y ? "graph 0.05\n" : "0\n");
  text += plot.series.empty()
              ? "set bmargin 6\nset key horizontal center bottom at screen 0.5, 0.02\n"
              : "set key outside right top title " + axis_label(data, plot.series, 24) + "\n";
  return text;
}

}  // namespace

std::string line_script(const Plot& plot, const PlotData& data) {
  const Collection points(plot, data);
  std::string settings = settings_of(plot, data, points);
  std::string curves;
  const char* style = points.makes_lines() ? "linespoints" : "points";
  for (std::size_t i = 0; i < points.series().size(); ++i) {
    const Series& one = points.series()[i];
    settings += gnuplot_data(fmt::format("series{}", i), one.points);
    curves +=
        fmt::format("{}$series{} using 1:2 with {} linetype {} {}", i == 0 ? "" : ", ", i, style,
                    i + 1, one.name.empty() ? "notitle" : "title " + gnuplot_text(one.name));
  }
  if (!points.prototypes().empty()) {
    settings += gnuplot_data("prototype", points.prototypes());
    curves +=
        ", $prototype using 1:2 with points pointtype 6 pointsize 3 linewidth 2 linecolor rgb "
        "'black' title 'prototype of 1984'";
  }
  return gnuplot_script(file_name_of(plot), settings,
                        curves.empty() ? "plot NaN notitle" : "plot " + curves);
}

}  // namespace maquette::sim
