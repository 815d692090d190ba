#include "sim/sweep/plot_script.hpp"

#include <fmt/format.h>

#include "sim/plot/gnuplot.hpp"
#include "sim/sweep/histogram_plot.hpp"
#include "sim/sweep/line_plot.hpp"
#include "sim/sweep/scatter_plot.hpp"
#include "sim/sweep/tornado_plot.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_title_letters = 100;

const TableColumn& column_of(const PlotData& data, const std::string& name) {
  return data.table.columns[data.table.find(name).value()];
}

}  // namespace

std::string plot_script(const Plot& plot, const PlotData& data) {
  switch (plot.kind) {
    case PlotKind::tornado:
      return tornado_script(plot, data);
    case PlotKind::histogram:
      return histogram_script(plot, data);
    case PlotKind::scatter:
      return scatter_script(plot, data);
    case PlotKind::lines:
      break;
  }
  return line_script(plot, data);
}

std::string title_settings(const Plot& plot, const PlotData& data) {
  const std::string& sentence = data.study.sentence.empty() ? data.study.name : data.study.sentence;
  const std::string& title = plot.title.empty() ? sentence : plot.title;
  return "set title " + gnuplot_text(wrapped(title, k_title_letters)) + "\n";
}

std::string axis_label(const PlotData& data, const std::string& column, std::size_t width) {
  const TableColumn& found = column_of(data, column);
  const std::string unit = found.unit == "1" ? "" : found.unit;
  const std::string heading = heading_of({found.name, unit, ""});
  return gnuplot_text(
      wrapped(found.sentence.empty() ? heading : heading + ": " + found.sentence, width));
}

std::optional<double> number_at(const PlotData& data, std::size_t row, const std::string& column) {
  return number_in(data.table.rows[row][data.table.find(column).value()]);
}

std::string with_unit_of(const PlotData& data, const std::string& column, double value) {
  const std::string& unit = column_of(data, column).unit;
  return gnuplot_number(value) + (unit.empty() || unit == "1" ? "" : " " + unit);
}

}  // namespace maquette::sim
