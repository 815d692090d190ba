#include "models/display/video_timing.hpp"

#include <stdexcept>

namespace maquette::models {

namespace {

constexpr std::int64_t k_ps_per_s = 1'000'000'000'000;

Period period_of_lines(const VideoParameters& parameters) {
  return {k_ps_per_s,
          static_cast<std::int64_t>(parameters.lines_per_frame) * parameters.frames_per_s};
}

}  // namespace

VideoTiming::VideoTiming(const VideoParameters& parameters, int width, int height)
    : width_(width),
      height_(height),
      lines_per_frame_(parameters.lines_per_frame),
      interlaced_(parameters.interlaced),
      first_line_field_1_(parameters.first_active_line_field_1 - 1),
      first_line_field_2_(parameters.first_active_line_field_2 - 1),
      blanking_(parameters.line_blanking),
      line_(period_of_lines(parameters)),
      pixel_(Period::of_frequency(parameters.pixel_clock_hz)) {
  if (width < 1 || height < 1 || first_line_field_1_ < 0) {
    throw std::invalid_argument("a picture needs pixels, and lines count from 1");
  }
  if (blanking_ < Duration::zero() || blanking_ + pixel_.times(width) > line_.times(1)) {
    throw std::invalid_argument("the pixels of a row do not fit into a video line");
  }
  const std::int64_t rows_field_1 = interlaced_ ? (height + 1) / 2 : height;
  const std::int64_t end_field_1 = interlaced_ ? first_line_field_2_ : lines_per_frame_;
  const std::int64_t rows_field_2 = interlaced_ ? height / 2 : 0;
  if (first_line_field_1_ + rows_field_1 > end_field_1 ||
      (interlaced_ && first_line_field_2_ + rows_field_2 > lines_per_frame_)) {
    throw std::invalid_argument("the rows of the picture do not fit into the lines of a frame");
  }
  for (std::int64_t line = 0; line < lines_per_frame_; ++line) {
    active_.push_back(row_of_line(line) >= 0);
  }
}

int VideoTiming::row_of_line(std::int64_t line_count) const {
  const std::int64_t line = line_count % lines_per_frame_;
  std::int64_t row = line - first_line_field_1_;
  if (interlaced_) {
    row = line < first_line_field_2_ ? 2 * row : 2 * (line - first_line_field_2_) + 1;
  }
  return row >= 0 && row < height_ ? static_cast<int>(row) : -1;
}

std::int64_t VideoTiming::line_of_row(int row) const {
  if (!interlaced_) {
    return first_line_field_1_ + row;
  }
  return (row % 2 == 0 ? first_line_field_1_ : first_line_field_2_) + row / 2;
}

ScanPosition VideoTiming::position(Instant instant) const {
  const std::int64_t line_count = line_at(instant);
  const std::int64_t line = line_count % lines_per_frame_;
  const std::int64_t frame = line_count / lines_per_frame_;
  const bool second =
      interlaced_ && field_end(instant) == line_.times((frame + 1) * lines_per_frame_);
  const Instant active = active_start(line_count);
  std::int64_t column = -1;
  const int row = row_of_line(line_count);
  if (row >= 0 && instant >= active) {
    const std::int64_t pixels = pixel_.index_at(instant - active);
    column = pixels < width_ ? pixels : -1;
  }
  return {frame, second ? 2 : 1, static_cast<int>(line) + 1, row, static_cast<int>(column)};
}

// A field lasts for half of the lines (312.5 of 625): the second one begins in mid-line.
Instant VideoTiming::field_end(Instant instant) const {
  const std::int64_t frame = line_at(instant) / lines_per_frame_;
  const Instant start = line_.times(frame * lines_per_frame_);
  const Instant end = line_.times((frame + 1) * lines_per_frame_);
  const Instant middle = start + (end - start) / 2;
  return interlaced_ && instant < middle ? middle : end;
}

Instant VideoTiming::scan_instant(std::int64_t frame, int column, int row) const {
  return active_start(frame * lines_per_frame_ + line_of_row(row)) + pixel_.times(column);
}

std::optional<Instant> VideoTiming::last_scan(int column, int row, Instant instant) const {
  const std::int64_t frame = line_at(instant) / lines_per_frame_;
  const Instant this_frame = scan_instant(frame, column, row);
  if (this_frame <= instant) {
    return this_frame;
  }
  if (frame == 0) {
    return std::nullopt;
  }
  return scan_instant(frame - 1, column, row);
}

}  // namespace maquette::models
