#pragma once

#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/trace/bus_record.hpp"
#include "sim/trace/trace_text.hpp"

namespace maquette::sim {

/// A stay in a state of a track: `kind` names a class of the chart's style.
struct ChartStay {
  std::string_view kind;
  models::Instant from;
  models::Instant to;
};

/// A horizontal band of the chart.
struct ChartBand {
  double top;
  double height;
};

/// An arrow from a track in an instant to another one in a later one.
struct ChartArrow {
  ChartBand from;
  models::Instant sent;
  ChartBand to;
  models::Instant arrived;
};

/// A picture of a window of time for a slide: 1280 x 720, tracks below one another over one axis,
/// a legend at the foot. Every state has a pattern besides its colour.
class SvgChart {
 public:
  SvgChart(const TraceWindow& window, const std::string& title, std::ostream& stream);

  /// A track of stays in order, which do not overlap. Where there are more of them than columns of
  /// the picture, each column shows the states by their shares of its time, one upon the other.
  void track(const ChartBand& band, const std::string& text, const std::vector<ChartStay>& stays);

  /// A value over time, as steps: instants in order, with the value from there on. Of more than
  /// the picture has columns, each column shows the largest.
  void steps(const ChartBand& band, const std::string& text,
             const std::vector<std::pair<models::Instant, int>>& values);

  /// A text in the middle of a stay, where there is room for it.
  void label(const ChartBand& band, const std::string& text, models::Instant from,
             models::Instant to);

  /// Arrows upon the tracks.
  void arrows(const std::vector<ChartArrow>& arrows);

  /// The axis below the tracks, the legend, and the end of the picture.
  void finish(double axis_top, const std::vector<std::pair<std::string_view, std::string>>& legend);

 private:
  [[nodiscard]] double x_of(models::Instant instant) const;
  [[nodiscard]] models::Instant column_start(int column) const;
  void box(std::string_view kind, double x0, double x1, double y, double height);
  void shares(const ChartBand& band, const std::vector<ChartStay>& stays);
  void name(const ChartBand& band, const std::string& name);
  void axis(double top);

  TraceWindow window_;
  TraceText text_;
};

}  // namespace maquette::sim
