#pragma once

#include <optional>
#include <vector>

#include "models/bus/period.hpp"
#include "models/display/video_parameters.hpp"

namespace maquette::models {

/// Where the video reader stands.
struct ScanPosition {
  std::int64_t frame;  ///< frames that are complete
  int field;           ///< 1 or 2
  int line;            ///< of the standard, from 1
  int row;             ///< of the picture, or -1 on a line that shows none
  int column;          ///< of the picture, or -1 outside the active part of the line
};

/// The video standard as closed forms of time, exact to the picosecond.
///
/// Assumptions: line 1 of a frame begins at instant 0; the pixel clock is locked to the line and
/// starts anew at each active line; the half-line that opens field 1 shows a whole row. Interlaced,
/// field 1 shows the even rows and field 2 the odd ones (line 23 lies above line 336); otherwise
/// the rows follow one another from first_active_line_field_1.
class VideoTiming {
 public:
  /// Throws std::invalid_argument when a picture of width x height does not fit into the standard.
  VideoTiming(const VideoParameters& parameters, int width, int height);

  /// Where the reader stands at `instant` >= 0.
  [[nodiscard]] ScanPosition position(Instant instant) const;

  /// When the field ends in which `instant` >= 0 is.
  [[nodiscard]] Instant field_end(Instant instant) const;

  /// The last instant up to `instant` at which the reader began to scan a pixel, if there was one.
  [[nodiscard]] std::optional<Instant> last_scan(int column, int row, Instant instant) const;

  /// Lines since instant 0 that had begun before or at `instant`, less one.
  [[nodiscard]] std::int64_t line_at(Instant instant) const { return line_.index_at(instant); }

  /// When a line (counted from instant 0) begins to show pixels, if it is one that does.
  [[nodiscard]] Instant active_start(std::int64_t line_count) const {
    return line_.times(line_count) + blanking_;
  }

  /// Whether a line (counted from instant 0) shows a row.
  [[nodiscard]] bool is_active(std::int64_t line_count) const {
    return active_[static_cast<std::size_t>(line_count % lines_per_frame_)];
  }

  /// The row that a line (counted from instant 0) shows, or -1.
  [[nodiscard]] int row_of_line(std::int64_t line_count) const;

  [[nodiscard]] const Period& pixel_period() const { return pixel_; }
  [[nodiscard]] const Period& line_period() const { return line_; }
  [[nodiscard]] Duration blanking() const { return blanking_; }
  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }

 private:
  [[nodiscard]] std::int64_t line_of_row(int row) const;
  [[nodiscard]] Instant scan_instant(std::int64_t frame, int column, int row) const;

  int width_;
  int height_;
  std::int64_t lines_per_frame_;
  bool interlaced_;
  std::int64_t first_line_field_1_;  // from 0
  std::int64_t first_line_field_2_;
  Duration blanking_;
  Period line_;
  Period pixel_;
  std::vector<bool> active_;  // by line of a frame
};

}  // namespace maquette::models
