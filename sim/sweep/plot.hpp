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

/// Whether a plot draws its values over a column `x`.
constexpr bool needs_x(PlotKind kind) {
  switch (kind) {
    case PlotKind::tornado:
    case PlotKind::histogram:
      return false;
    case PlotKind::lines:
    case PlotKind::scatter:
      break;
  }
  return true;
}

/// Whether a plot compares points that vary a single axis each.
constexpr bool needs_single_axes(PlotKind kind) {
  switch (kind) {
    case PlotKind::lines:
    case PlotKind::histogram:
    case PlotKind::scatter:
      return false;
    case PlotKind::tornado:
      break;
  }
  return true;
}

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
