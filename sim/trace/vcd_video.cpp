#include "sim/trace/vcd_video.hpp"

namespace maquette::sim {

namespace {

constexpr const char* k_scope = "video_reader";
constexpr int k_field_bits = 2;
constexpr int k_number_bits = 16;

}  // namespace

std::vector<ChangeSource> dump_video(const VideoRecord& record, VcdDump& dump) {
  const std::uint16_t field = dump.add(k_scope, "field", SignalKind::vector, k_field_bits);
  const std::uint16_t line = dump.add(k_scope, "line", SignalKind::vector, k_number_bits);
  const std::uint16_t row = dump.add(k_scope, "row", SignalKind::vector, k_number_bits);
  const std::uint16_t wait = dump.add(k_scope, "WAIT_n", SignalKind::active_low);
  const auto tell_field = [&dump, field](const RecordedField& one) {
    dump.set(field, one.from, static_cast<std::uint64_t>(one.field));
  };
  const auto tell_line = [&dump, line, row](const RecordedLine& one) {
    dump.set(line, one.from, static_cast<std::uint64_t>(one.line));
    if (one.row < 0) {
      dump.release(row, one.from);
    } else {
      dump.set(row, one.from, static_cast<std::uint64_t>(one.row));
    }
  };
  // Delays come in any order, and are few beside the lines: all at once.
  const auto tell_delays = [&dump, &record, wait] {
    for (const RecordedDelay& delay : record.delays) {
      dump.assert_during(wait, delay.from, delay.to);
    }
    return models::k_never;
  };
  return {source_of(record.fields, tell_field),
          source_of(record.lines, tell_line),
          {models::Instant::min(), tell_delays}};
}

}  // namespace maquette::sim
