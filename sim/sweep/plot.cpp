#include "sim/sweep/plot.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

Plot parse_plot(const std::string& text) {
  Plot plot;
  plot.place.file = std::make_shared<const std::string>("--plot " + text);
  std::vector<std::string> columns;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    columns.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  const bool has_gap =
      std::any_of(columns.begin(), columns.end(), [](const auto& name) { return name.empty(); });
  if (columns.size() < 2 || columns.size() > 3 || has_gap) {
    throw DescriptionError(plot.place.position(), "x,y or x,y,series is allowed");
  }
  plot.x = columns[0];
  plot.y = columns[1];
  plot.series = columns.size() == 3 ? columns[2] : "";
  return plot;
}

std::string file_name_of(const Plot& plot) {
  if (!plot.name.empty()) {
    return plot.name;
  }
  switch (plot.kind) {
    case PlotKind::tornado:
      return "tornado-" + plot.y;
    case PlotKind::histogram:
      return "histogram-" + plot.y;
    case PlotKind::scatter:
      return "scatter-" + plot.y + "-over-" + plot.x;
    case PlotKind::lines:
      break;
  }
  return plot.y + "-over-" + plot.x + (plot.series.empty() ? "" : "-by-" + plot.series);
}

}  // namespace maquette::sim
