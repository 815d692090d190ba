#include "sim/command_line/plot_options.hpp"

#include <algorithm>

namespace maquette::sim {

namespace {

bool has_axis(const PlotOptions& options, const char* axis) {
  return std::find(options.logarithmic.begin(), options.logarithmic.end(), axis) !=
         options.logarithmic.end();
}

}  // namespace

void add_plot_options(CLI::App& verb, PlotOptions& options) {
  CLI::Option* const plot =
      verb.add_option("--plot", options.columns, "draw a column over another one (repeatable)")
          ->type_name("X,Y[,SERIES]")
          ->expected(1)
          ->take_all();
  verb.add_option("--log", options.logarithmic, "logarithmic axes of the plots: x, y, or x,y")
      ->type_name("AXES")
      ->delimiter(',')
      ->check(CLI::IsMember({"x", "y"}))
      ->needs(plot);
  verb.add_option("--title", options.title, "above the plots (default: what the study asks)")
      ->type_name("TEXT")
      ->needs(plot);
}

std::vector<Plot> plots_of(const PlotOptions& options) {
  std::vector<Plot> plots;
  for (const std::string& columns : options.columns) {
    Plot plot = parse_plot(columns);
    plot.log_x = has_axis(options, "x");
    plot.log_y = has_axis(options, "y");
    plot.title = options.title;
    plots.push_back(std::move(plot));
  }
  return plots;
}

}  // namespace maquette::sim
