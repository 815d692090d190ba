#include "sim/accuracy/accuracy_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/plot/gnuplot.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {

namespace {

/// A level in a plot.
struct Mark {
  std::string name;
  PlotPoint place;
  double least;  ///< of its spread along the axis
  double most;
  bool is_on_front;
  bool is_reference;
};

/// A decade below the least error that is not zero.
double floor_of(const LadderResult& result) {
  double least = std::numeric_limits<double>::infinity();
  for (const LevelResult& level : result.levels) {
    if (level.magnitude > 0) {
      least = std::min(least, level.magnitude);
    }
  }
  return std::isfinite(least) ? std::pow(10, std::floor(std::log10(least)) - 1) : 1e-3;
}

const char* title_of(ErrorMeasure measure) {
  switch (measure) {
    case ErrorMeasure::frame_time:
      return "error of the frame time, relative";
    case ErrorMeasure::picture:
      break;
  }
  return "mean error of the picture, levels of 255";
}

std::string settings_of(const LadderResult& result, double floor, const char* x_label) {
  return fmt::format(
      "set title {}\nset xlabel {}\nset ylabel {}\nset logscale y\nset format y '%g'\n"
      "set ytics add ('0' {})\nset yrange [{}:*]\nset autoscale xfix\n"
      "set offsets graph 0.04, graph 0.16, graph 0.06, 0\n"
      "set bmargin 6\nset key horizontal center bottom at screen 0.5, 0.02\n",
      gnuplot_text(fmt::format("{}: {}", result.ladder.name, result.ladder.varies)),
      gnuplot_text(x_label),
      gnuplot_text(fmt::format("{}, against {}", title_of(result.ladder.measure),
                               result.ladder.reference_name())),
      floor, floor / 2);
}

std::vector<PlotPoint> places_of(const std::vector<Mark>& marks, bool (*wanted)(const Mark&)) {
  std::vector<PlotPoint> places;
  for (const Mark& mark : marks) {
    if (wanted(mark)) {
      places.push_back(mark.place);
    }
  }
  std::sort(places.begin(), places.end(),
            [](const PlotPoint& a, const PlotPoint& b) { return a.x < b.x; });
  return places;
}

std::string script_of(const std::string& name, std::string settings,
                      const std::vector<Mark>& marks) {
  for (const Mark& mark : marks) {
    settings += fmt::format("set label {} at {}, {} left offset 1, 0.4\n", gnuplot_text(mark.name),
                            mark.place.x, mark.place.y);
  }
  std::vector<std::vector<double>> spreads;
  spreads.reserve(marks.size());
  for (const Mark& mark : marks) {
    spreads.push_back({mark.place.x, mark.place.y, mark.least, mark.most});
  }
  settings += gnuplot_data("spreads", spreads);
  std::string curves =
      "plot $spreads using 1:2:3:4 with xerrorbars pointtype 0 linewidth 1 linecolor rgb "
      "'#999999' notitle";
  const auto add = [&](const char* block, bool (*wanted)(const Mark&), const std::string& style) {
    if (const std::vector<PlotPoint> places = places_of(marks, wanted); !places.empty()) {
      settings += gnuplot_data(block, places);
      curves += fmt::format(", ${} using 1:2 with {}", block, style);
    }
  };
  add(
      "front", [](const Mark& mark) { return mark.is_on_front; },
      "linespoints linetype 1 pointsize 1.6 title 'Pareto front'");
  add(
      "others", [](const Mark& mark) { return !mark.is_on_front; },
      "points pointtype 7 pointsize 1.2 linecolor rgb '#999999' title 'others'");
  add(
      "reference", [](const Mark& mark) { return mark.is_reference; },
      "points pointtype 6 pointsize 3 linewidth 2 linecolor rgb 'black' title 'reference'");
  return gnuplot_script(name, settings, curves);
}

std::vector<Mark> marks_over_host_time(const LadderResult& result, double floor) {
  std::vector<Mark> marks;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const LevelResult& level = result.levels[i];
    marks.push_back({result.ladder.levels[i].name,
                     {level.host.median_s, std::max(level.magnitude, floor)},
                     level.host.least_s,
                     level.host.most_s,
                     level.is_on_host_front,
                     i == result.ladder.reference});
  }
  return marks;
}

/// Levels whose host times are far apart would hide one another on a linear axis.
const char* host_axis_of(const LadderResult& result) {
  constexpr double k_far = 10;
  double least = std::numeric_limits<double>::infinity();
  double most = 0;
  for (const LevelResult& level : result.levels) {
    least = std::min(least, level.host.least_s);
    most = std::max(most, level.host.most_s);
  }
  return least > 0 && most > k_far * least ? "set logscale x\n" : "";
}

std::vector<Mark> marks_over_simulated_time(const LadderResult& result, double floor) {
  std::vector<Mark> marks = marks_over_host_time(result, floor);
  for (std::size_t i = 0; i < marks.size(); ++i) {
    const LevelResult& level = result.levels[i];
    marks[i].place.x = marks[i].least = marks[i].most = in_seconds(level.simulated->frame);
    marks[i].is_on_front = level.is_on_simulated_front;
  }
  return marks;
}

bool is_simulated(const LadderResult& result) {
  return std::all_of(result.levels.begin(), result.levels.end(),
                     [](const LevelResult& level) { return level.simulated.has_value(); });
}

}  // namespace

std::vector<AccuracyPlot> accuracy_plots(const std::vector<LadderResult>& results) {
  std::vector<AccuracyPlot> plots;
  for (const LadderResult& result : results) {
    const double floor = floor_of(result);
    const std::string over_host = result.ladder.name + "-over-host-time";
    plots.push_back({over_host, script_of(over_host,
                                          settings_of(result, floor,
                                                      "processor time on the host [s]: median, "
                                                      "least and most") +
                                              host_axis_of(result),
                                          marks_over_host_time(result, floor))});
    if (is_simulated(result)) {
      const std::string over_simulated = result.ladder.name + "-over-simulated-time";
      plots.push_back(
          {over_simulated,
           script_of(over_simulated, settings_of(result, floor, "simulated frame time [s]"),
                     marks_over_simulated_time(result, floor))});
    }
  }
  return plots;
}

}  // namespace maquette::sim
