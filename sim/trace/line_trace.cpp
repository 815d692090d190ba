#include "sim/trace/line_trace.hpp"

#include <algorithm>
#include <string_view>

namespace maquette::sim {

namespace {

constexpr std::string_view k_comment =
    R"(  The lines of the VERSAbus as they were simulated (bus.level signal); time 0 is the frame's start.
  Names that end in _n are active low, as the signal with a star is on the backplane; a line that
  nobody pulls low is high. BG0..4 leave the arbiter, BGOUT the board of that name. Whoever has had
  the bus leaves address and data as they were. What lasts no time is not seen.
)";

}  // namespace

LineTrace::LineTrace(const std::string& file, const TraceWindow& window)
    : file_(file), text_(file_.stream()), window_(window) {}

std::size_t LineTrace::add(const VcdVariable& line, std::uint64_t value) {
  const std::size_t number = text_.add(line);
  text_.set(number, value);
  return number;
}

void LineTrace::change(std::size_t line, models::Instant at, std::uint64_t value) {
  if (at > latest_) {
    show_before(at);
    latest_ = at;
  }
  text_.set(line, value);
}

// All changes before an instant are known, those of the latest one not shown.
void LineTrace::show_before(models::Instant at) {
  if (!has_begun_) {
    if (at > window_.from) {
      text_.declare(k_comment);
      text_.show_all(window_.from);
      has_begun_ = true;
    }
  } else if (latest_ < window_.to) {
    text_.show_changes(latest_);
  }
}

void LineTrace::publish(models::Instant frame_end) {
  window_.to = std::min(window_.to, frame_end);
  window_.from = std::min(window_.from, window_.to);
  show_before(models::k_never);
  text_.end(window_.to);
  file_.publish();
}

}  // namespace maquette::sim
