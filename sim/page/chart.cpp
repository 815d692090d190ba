#include "sim/page/chart.hpp"

#include <nlohmann/json.hpp>

namespace maquette::sim {
namespace {

using Json = nlohmann::ordered_json;

const char* name_of(ChartKind kind) {
  switch (kind) {
    case ChartKind::bars:
      return "bars";
    case ChartKind::columns:
      return "columns";
    case ChartKind::lines:
      return "lines";
    case ChartKind::scatter:
      break;
  }
  return "scatter";
}

Json series_of(const Chart& chart) {
  Json all = Json::array();
  for (const ChartSeries& series : chart.series) {
    Json points = Json::array();
    for (const ChartPoint& point : series.points) {
      points.push_back({{"x", point.x}, {"y", point.y}, {"label", point.label}});
    }
    all.push_back({{"name", series.name}, {"values", series.values}, {"points", points}});
  }
  return all;
}

std::string json_of(const Chart& chart) {
  const Json json = {{"kind", name_of(chart.kind)},
                     {"x_title", chart.x_title},
                     {"y_title", chart.y_title},
                     {"logarithmic_x", chart.is_logarithmic_x},
                     {"logarithmic_y", chart.is_logarithmic_y},
                     {"labels", chart.labels},
                     {"series", series_of(chart)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

Html chart_element(const Chart& chart) {
  const Html plot = element(
      "div", {{"class", "plot"}},
      element("canvas", {{"role", "img"}, {"aria-label", chart.title + ". " + chart.summary}}, {}));
  return element(
      "figure", {{"class", "chart"}, {"id", chart.id}},
      plot + element("figcaption", chart.title) + data_element(chart.id + "-data", json_of(chart)));
}

}  // namespace maquette::sim
