#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/report/table.hpp"
#include "sim/sweep/plot.hpp"
#include "sim/sweep/study.hpp"

namespace maquette::sim {

/// What plots are drawn of.
struct PlotData {
  const Study& study;
  const Table& table;
  std::vector<bool> prototypes;  ///< rows whose machine is the prototype as documented
};

/// The gnuplot script of a plot, which draws file_name_of(plot).png and .svg.
[[nodiscard]] std::string plot_script(const Plot& plot, const PlotData& data);

/// Title, which is the plot's own or the study's sentence.
[[nodiscard]] std::string title_settings(const Plot& plot, const PlotData& data);

/// Name, unit and sentence of a column, for an axis that is about `width` letters long.
[[nodiscard]] std::string axis_label(const PlotData& data, const std::string& column,
                                     std::size_t width);

/// The number of a column in a row; nothing when there is none.
[[nodiscard]] std::optional<double> number_at(const PlotData& data, std::size_t row,
                                              const std::string& column);

/// A number with the unit of a column.
[[nodiscard]] std::string with_unit_of(const PlotData& data, const std::string& column,
                                       double value);

}  // namespace maquette::sim
