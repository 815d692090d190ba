#include "sim/trace/chrome_video.hpp"

namespace maquette::sim {

namespace {

constexpr int k_fields = 1;
constexpr int k_lines = 2;
constexpr int k_delays = 3;

}  // namespace

void add_video(const VideoRecord& record, int process, ChromeEvents& events) {
  events.name_process(process, "video reader");
  events.name_thread({process, k_fields}, "field");
  for (const RecordedField& field : record.fields) {
    events.slice({process, k_fields}, fmt::format("field {}", field.field), field.from, field.to);
  }
  events.name_thread({process, k_lines}, "line");
  for (const RecordedLine& line : record.lines) {
    events.slice({process, k_lines}, fmt::format("line {}", line.line), line.from, line.to,
                 line.row < 0 ? "" : fmt::format(R"(,"args":{{"row":{}}})", line.row));
  }
  events.name_thread({process, k_delays}, "accesses that wait for a slot");
  for (const RecordedDelay& delay : record.delays) {
    events.slice({process, k_delays}, "waits", delay.from, delay.to);
  }
}

}  // namespace maquette::sim
