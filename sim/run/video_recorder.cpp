#include "sim/run/video_recorder.hpp"

#include <algorithm>
#include <memory>
#include <vector>

#include "models/bus/kernel_time.hpp"

namespace maquette::sim {

namespace {

using models::Instant;

constexpr const char* k_scope = "video_reader";

void show_lines(models::CcettMachine& model, models::VideoReader& reader, LineTrace& trace) {
  const auto numbers = std::make_shared<std::vector<std::size_t>>();
  reader.observe([&model, &trace, numbers](const models::LineState& line) {
    const auto number = static_cast<std::size_t>(line.line);
    if (number == numbers->size()) {
      numbers->push_back(trace.add({k_scope, line.name, line.bits}, line.value));
    } else {
      trace.change((*numbers)[number], models::kernel_now() - *model.started(), line.value);
    }
  });
}

}  // namespace

void watch_video(models::CcettMachine& model, const TraceWindow& window, LineTrace* lines,
                 BusRecord& record) {
  models::VideoReader& reader = model.watch_video(window.from, window.to);
  if (lines != nullptr) {
    show_lines(model, reader, *lines);
  }
  VideoRecord& video = record.video.emplace();
  model.observe_memory([&model, &video, window](const models::MemoryAccess& access) {
    const std::optional<Instant> start = model.started();
    if (start && access.begun > access.asked && access.begun > *start + window.from &&
        access.asked - *start < window.to) {
      video.delays.push_back({access.asked - *start, access.begun - *start});
    }
  });
}

void finish_video_record(const models::CcettMachine& model, BusRecord& record) {
  const Instant start = model.statistics().load_time;
  const models::VideoTiming& timing = model.video_timing();
  const TraceWindow& window = record.window;
  VideoRecord& video = *record.video;
  for (RecordedDelay& delay : video.delays) {
    delay = {window.clip(delay.from), window.clip(delay.to)};
  }
  std::sort(video.delays.begin(), video.delays.end(),
            [](const RecordedDelay& a, const RecordedDelay& b) { return a.from < b.from; });
  for (Instant from = window.from; from < window.to; from = video.fields.back().to) {
    video.fields.push_back({from, window.clip(timing.field_end(start + from) - start),
                            timing.position(start + from).field});
  }
  std::int64_t number = timing.line_at(start + window.from);
  for (Instant from = window.from; from < window.to; from = video.lines.back().to) {
    const models::ScanPosition position = timing.position(start + from);
    ++number;
    video.lines.push_back({from, window.clip(timing.line_period().times(number) - start),
                           position.line, position.row});
  }
}

}  // namespace maquette::sim
