#include "sim/trace/vcd_video.hpp"

namespace maquette::sim {

namespace {

constexpr const char* k_scope = "video_reader";
constexpr int k_field_bits = 2;
constexpr int k_number_bits = 16;

}  // namespace

void dump_video(const VideoRecord& record, VcdDump& dump) {
  const std::uint16_t field = dump.add(k_scope, "field", SignalKind::vector, k_field_bits);
  const std::uint16_t line = dump.add(k_scope, "line", SignalKind::vector, k_number_bits);
  const std::uint16_t row = dump.add(k_scope, "row", SignalKind::vector, k_number_bits);
  const std::uint16_t wait = dump.add(k_scope, "WAIT_n", SignalKind::active_low);
  for (const RecordedField& one : record.fields) {
    dump.set(field, one.from, static_cast<std::uint32_t>(one.field));
  }
  for (const RecordedLine& one : record.lines) {
    dump.set(line, one.from, static_cast<std::uint32_t>(one.line));
    if (one.row < 0) {
      dump.release(row, one.from);
    } else {
      dump.set(row, one.from, static_cast<std::uint32_t>(one.row));
    }
  }
  for (const RecordedDelay& delay : record.delays) {
    dump.assert_during(wait, delay.from, delay.to);
  }
}

}  // namespace maquette::sim
