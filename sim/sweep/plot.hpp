#pragma once

#include <string>

#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// How a plot shows the table of a study.
enum class PlotKind {
  lines,      ///< `y` over `x`, one line for each value of `series`
  tornado,    ///< how far each axis alone moves `y`, the largest first
  histogram,  ///< how often `y` has which value, with the interval that holds 90 %
  scatter     ///< `y` over `x`, marked where `band` lies between band_low and band_high
};

/// A plot of a study. Columns are named as in the table, without their units.
struct Plot {
  std::string name;  ///< of its files
  PlotKind kind = PlotKind::lines;
  std::string x;
  std::string y;
  std::string series;
  std::string band;
  double band_low = 0;
  double band_high = 0;
  bool log_x = false;
  bool log_y = false;
  std::string title;
  YamlPlace place;  ///< where it was asked for
};

/// Reads "x,y" or "x,y,series" of --plot. Throws DescriptionError.
[[nodiscard]] Plot parse_plot(const std::string& text);

/// The name of a plot's files: its own, or one made of its columns.
[[nodiscard]] std::string file_name_of(const Plot& plot);

}  // namespace maquette::sim
