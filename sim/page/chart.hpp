#pragma once

#include <string>
#include <vector>

#include "sim/page/html.hpp"

namespace maquette::sim {

/// A mark of a chart: where it is, or how long a bar is, and what it is called.
struct ChartPoint {
  double x = 0;
  double y = 0;
  std::string label;
};

/// What is drawn in one colour and pattern. Bars have `values`, one for each label of the chart;
/// lines and scattered marks have `points`.
struct ChartSeries {
  std::string name;
  std::vector<double> values = {};
  std::vector<ChartPoint> points = {};
};

enum class ChartKind {
  bars,     ///< horizontal, one for each label; of several series stacked
  columns,  ///< vertical, one for each label; of several series stacked
  lines,    ///< through points
  scatter   ///< points alone
};

/// One plot, as data: the script hands it to the library that draws. What it shows stands in a
/// table of the page as well.
struct Chart {
  std::string id;       ///< unique in the page
  std::string title;    ///< stands below
  std::string summary;  ///< for those who do not see it
  ChartKind kind = ChartKind::bars;
  std::string x_title;  ///< with the unit
  std::string y_title;
  bool is_logarithmic_x = false;
  bool is_logarithmic_y = false;
  std::vector<std::string> labels = {};
  std::vector<ChartSeries> series = {};
};

/// The place of a chart with its data; without scripts it shows nothing.
[[nodiscard]] Html chart_element(const Chart& chart);

}  // namespace maquette::sim
