#include "models/display/video_reader.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

namespace {

constexpr int k_word_bits = 16;

struct ShownLine {
  std::string name;
  int bits;
};

const std::vector<ShownLine>& shown_lines() {
  static const std::vector<ShownLine> lines{{"FIELD", 2},         {"LINE", k_word_bits},
                                            {"ROW", k_word_bits}, {"SLOT", 1},
                                            {"CLOSED", 1},        {"WAITING", k_word_bits}};
  return lines;
}

}  // namespace

VideoReader::VideoReader(const sc_core::sc_module_name& name, const VideoParameters& standard,
                         const FrameMemoryParameters& parameters, VideoWatch watch)
    : sc_module(name),
      field("field"),
      line("line"),
      row("row"),
      fetches("fetches"),
      closed("closed"),
      waiting("waiting"),
      standard_(standard),
      timing_(standard, parameters.width, parameters.height),
      watch_(std::move(watch)) {
  if (has_video_slots(parameters)) {
    slots_.emplace(timing_, parameters);
  }
  SC_HAS_PROCESS(VideoReader);
  SC_THREAD(run);
}

void VideoReader::tell(const MemoryAccess& access) {
  if (!is_over_) {
    told_accesses_.emplace(access.asked, access);
    told_.notify(sc_core::SC_ZERO_TIME);
  }
}

void VideoReader::run() {
  sc_core::wait(watch_.start);
  if (watch_.from > Duration::zero()) {
    sc_core::wait(to_sc_time(watch_.from));
  }
  const Instant first = kernel_now();
  const Instant end = watch_.to == k_never ? k_never : first - watch_.from + watch_.to;
  begin(first);
  while (kernel_now() < end && !is_over_) {
    const Instant now = kernel_now();
    while (next_change() <= now) {
      step(now);
    }
    drive();
    if (!is_over_) {
      sc_core::wait(to_sc_time(std::min(next_change(), end) - now), told_);
    }
  }
  is_over_ = true;
  told_accesses_.clear();
}

// The beam is where the closed form has it; from here on it is followed.
void VideoReader::begin(Instant now) {
  const ScanPosition position = timing_.position(now);
  lines_ = timing_.line_at(now);
  line_ = position.line;
  row_ = position.row;
  field_ = position.field;
  next_line_ = timing_.line_period().times(lines_ + 1);
  const std::int64_t frame = lines_ / standard_.lines_per_frame;
  next_field_ = standard_.interlaced && field_ == 1 ? middle_of(frame) : k_never;
  if (slots_) {
    slots_->enter(now);
    aim_at_slot();
    closed_ = next_close_ <= now;
    fetches_ = next_fetch_ <= now;
    next_close_ = closed_ ? k_never : next_close_;
    next_fetch_ = fetches_ ? k_never : next_fetch_;
    closed_changed_ = now;
  }
  began_ = now;
}

Instant VideoReader::middle_of(std::int64_t frame) const {
  const Instant begin = timing_.line_period().times(frame * standard_.lines_per_frame);
  const Instant end = timing_.line_period().times((frame + 1) * standard_.lines_per_frame);
  return begin + (end - begin) / 2;
}

Instant VideoReader::next_change() const {
  const Instant asked = told_accesses_.empty() ? k_never : told_accesses_.begin()->first;
  return std::min({next_line_, next_field_, next_close_, next_fetch_, next_open_, asked});
}

// What changes in one instant comes before the accesses of that instant.
void VideoReader::step(Instant now) {
  if (next_line_ <= now) {
    begin_line();
  }
  if (next_field_ <= now) {
    field_ = 2;
    next_field_ = k_never;
  }
  step_slot(now);
  while (!told_accesses_.empty() && told_accesses_.begin()->first <= now) {
    take(told_accesses_.begin()->second);
    told_accesses_.erase(told_accesses_.begin());
  }
}

void VideoReader::begin_line() {
  ++lines_;
  next_line_ = timing_.line_period().times(lines_ + 1);
  if (line_ == standard_.lines_per_frame) {
    line_ = 0;
    field_ = 1;
    next_field_ = standard_.interlaced ? middle_of(lines_ / standard_.lines_per_frame) : k_never;
  }
  ++line_;
  if (line_ == standard_.first_active_line_field_1) {
    row_ = 0;
  } else if (standard_.interlaced && line_ == standard_.first_active_line_field_2) {
    row_ = 1;
  } else if (row_ >= 0) {
    row_ += standard_.interlaced ? 2 : 1;
  }
  row_ = row_ < timing_.height() ? row_ : -1;
  is_over_ = watch_.is_over && watch_.is_over();
}

void VideoReader::step_slot(Instant now) {
  if (next_open_ <= now) {
    closed_changed_ = closed_ ? next_open_ : closed_changed_;
    for (const MemoryAccess& access : waiting_) {
      compare(access, next_open_);
    }
    waiting_.clear();
    closed_ = false;
    fetches_ = false;
    slots_->next();
    aim_at_slot();
  }
  if (next_close_ <= now) {
    closed_ = true;
    closed_changed_ = next_close_;
    next_close_ = k_never;
  }
  if (next_fetch_ <= now) {
    fetches_ = true;
    next_fetch_ = k_never;
  }
}

void VideoReader::aim_at_slot() {
  next_open_ = slots_->end();
  next_fetch_ = slots_->begin();
  next_close_ = slots_->too_late() < next_open_ ? slots_->too_late() : k_never;
}

void VideoReader::take(const MemoryAccess& access) {
  if (access.asked < began_) {
    return;
  }
  const bool is_past = access.asked < closed_changed_;
  if (closed_ != is_past) {  // closed when it was asked for
    if (closed_) {
      waiting_.push_back(access);
    } else {
      compare(access, closed_changed_);
    }
  } else {
    compare(access, access.asked);
  }
}

void VideoReader::compare(const MemoryAccess& access, Instant begun) {
  if (access.begun != begun) {
    const std::string message = "an access asked for at " + std::to_string(access.asked.count()) +
                                " ps begins at " + std::to_string(access.begun.count()) +
                                " ps, by the video reader at " + std::to_string(begun.count()) +
                                " ps";
    SC_REPORT_ERROR("/maquette/video_reader", message.c_str());
  }
  ++compared_;
}

void VideoReader::drive() {
  field.write(field_);
  line.write(line_);
  row.write(row_);
  fetches.write(fetches_);
  closed.write(closed_);
  waiting.write(static_cast<int>(waiting_.size()));
  if (observer_) {
    const std::array<std::uint64_t, 6> values{static_cast<std::uint64_t>(field_),
                                              static_cast<std::uint64_t>(line_),
                                              static_cast<std::uint16_t>(row_),
                                              fetches_ ? 1U : 0U,
                                              closed_ ? 1U : 0U,
                                              waiting_.size()};
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (shown_[i] != values[i]) {
        show(i, values[i]);
      }
    }
  }
}

void VideoReader::show(std::size_t number, std::uint64_t value) {
  const ShownLine& shown = shown_lines()[number];
  observer_({static_cast<int>(number), shown.name, shown.bits, value});
  shown_[number] = value;
}

void VideoReader::observe(LineObserver observer) {
  observer_ = std::move(observer);
  shown_.resize(shown_lines().size());
  for (std::size_t i = 0; i < shown_.size(); ++i) {
    show(i, 0);
  }
}

}  // namespace maquette::models
