#include "sim/trace/vcd_trace.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "sim/trace/trace_text.hpp"
#include "sim/trace/vcd_bus.hpp"
#include "sim/trace/vcd_changes.hpp"
#include "sim/trace/vcd_dump.hpp"
#include "sim/trace/vcd_text.hpp"
#include "sim/trace/vcd_video.hpp"

namespace maquette::sim {

namespace {

using models::Instant;

constexpr std::string_view k_comment =
    R"(  Transaction-level trace of the VERSAbus; time 0 is the frame's start. Names that end in _n are
  active low. Exact instants: BR (request to grant), BG (begin of the arbitration to grant), BBSY
  (grant to release), DTACK falling (the slave's answer), and the end of each access. Derived within
  an access: AS and DS fall together at the grant and rise together with DTACK and WRITE at its end,
  as the access law counts its clocks; skews of single lines are below this level.
  state of a board: 0 computes, 1 waits for its grant, 2 transfers, 3 is idle; owner: number of the
  board that has the bus.
)";

constexpr bool is_count(SignalKind kind) {
  switch (kind) {
    case SignalKind::active_low:
      return true;
    case SignalKind::vector:
      break;
  }
  return false;
}

// The signals as variables of a dump, which changes are applied to in turn.
class VcdTrace {
 public:
  VcdTrace(const VcdDump& dump, std::ostream& stream)
      : signals_(dump.signals), counts_(dump.signals.size()), text_(stream) {
    for (std::size_t i = 0; i < signals_.size(); ++i) {
      const DumpedSignal& signal = signals_[i];
      text_.add({signal.scope, signal.name, signal.bits});
      if (is_count(signal.kind)) {
        text_.set(i, k_high);
      }
    }
    text_.declare(k_comment);
  }

  void apply(const SignalChange& change) {
    if (is_count(signals_[change.signal].kind)) {
      counts_[change.signal] += change.value;
      text_.set(change.signal, counts_[change.signal] > 0 ? k_low : k_high);
    } else {
      text_.set(change.signal, change.floats ? std::nullopt : std::optional(change.value));
    }
  }

  VcdText& text() { return text_; }

 private:
  static constexpr std::uint64_t k_low = 0;
  static constexpr std::uint64_t k_high = 1;

  const std::vector<DumpedSignal>& signals_;
  std::vector<std::uint64_t> counts_;  // of those that assert an active-low signal
  VcdText text_;
};

/// Adds all signals; what tells of their changes.
std::vector<ChangeSource> dump_all(const BusRecord& record, const std::vector<std::size_t>& boards,
                                   VcdDump& dump) {
  std::vector<ChangeSource> sources;
  const auto add = [&sources](std::vector<ChangeSource> more) {
    std::move(more.begin(), more.end(), std::back_inserter(sources));
  };
  for (const RecordedBus& bus : record.buses) {
    add(dump_bus(record, bus, dump));
  }
  for (const std::size_t board : boards) {
    sources.push_back(dump_board(record, board, dump));
  }
  if (record.video) {
    add(dump_video(*record.video, dump));
  }
  return sources;
}

/// The same machine, of which nothing was seen.
BusRecord without_accesses(const BusRecord& record) {
  BusRecord empty{record.window, record.boards, {}, std::nullopt};
  for (const RecordedBus& bus : record.buses) {
    empty.buses.push_back({bus.name, bus.data_bits, {}, {}});
  }
  if (record.video) {
    empty.video.emplace();
  }
  return empty;
}

/// How GTKWave shows a signal, by the bits of its save files.
const char* format_of(const DumpedSignal& signal) {
  constexpr const char* k_hexadecimal = "@22";
  constexpr const char* k_decimal = "@24";
  constexpr const char* k_binary = "@28";
  if (signal.bits == 1) {
    return k_binary;
  }
  return signal.name == "address" || signal.name == "data" ? k_hexadecimal : k_decimal;
}

}  // namespace

void write_vcd_trace(const BusRecord& record, const std::vector<std::size_t>& boards,
                     std::ostream& stream) {
  VcdDump dump;
  ChangesInOrder changes(dump, dump_all(record, boards, dump));
  VcdTrace trace(dump, stream);
  while (changes.has_at_most(record.window.from)) {
    trace.apply(changes.take());
  }
  trace.text().show_all(record.window.from);
  while (changes.has_before(record.window.to)) {
    const SignalChange change = changes.take();
    const Instant now = change.at;
    trace.apply(change);
    while (changes.has_at_most(now)) {
      trace.apply(changes.take());
    }
    trace.text().show_changes(now);
  }
  trace.text().end(record.window.to);
}

void write_gtkwave_view(const BusRecord& record, const std::vector<std::size_t>& boards,
                        const std::string& trace, std::ostream& stream) {
  TraceText text(stream);
  text.add("{}\n[dumpfile] \"{}\"\n[timestart] {}\n", k_gtkwave_mark, trace,
           record.window.from.count());
  std::string scope;
  const auto close = [&] {
    if (!scope.empty()) {
      text.add("@1000200\n-{}\n", scope);
    }
  };
  const BusRecord empty = without_accesses(record);
  VcdDump dump;
  dump_all(empty, boards, dump);
  for (const DumpedSignal& signal : dump.signals) {
    if (signal.scope != scope) {
      close();
      scope = signal.scope;
      text.add("@800200\n-{}\n", scope);
    }
    text.add("{}\n{}.{}{}\n", format_of(signal), scope, signal.name,
             signal.bits > 1 ? fmt::format("[{}:0]", signal.bits - 1) : "");
  }
  close();
}

// Measured on whole frames.
std::int64_t expected_vcd_trace_bytes(const BusRecord& record) {
  return expected_bytes(record, 135, 65, 55);
}

}  // namespace maquette::sim
