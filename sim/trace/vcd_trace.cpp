#include "sim/trace/vcd_trace.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "sim/trace/board_states.hpp"
#include "sim/trace/trace_text.hpp"
#include "sim/trace/vcd_dump.hpp"
#include "sim/trace/vcd_text.hpp"
#include "sim/trace/vcd_video.hpp"

namespace maquette::sim {

namespace {

using models::Instant;

constexpr int k_levels = 5;
constexpr int k_address_bits = 32;
constexpr int k_owner_bits = 16;
constexpr int k_state_bits = 2;
static_assert(static_cast<int>(BoardState::idle) < 1 << k_state_bits);
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

constexpr std::uint16_t after(std::uint16_t signal, int places) {
  return static_cast<std::uint16_t>(signal + places);
}

struct BusSignals {
  BusSignals(VcdDump& dump, const RecordedBus& bus)
      : request(levels(dump, bus.name, "BR")),
        grant(levels(dump, bus.name, "BG")),
        busy(dump.add(bus.name, "BBSY_n", SignalKind::active_low)),
        address_strobe(dump.add(bus.name, "AS_n", SignalKind::active_low)),
        data_strobe(dump.add(bus.name, "DS_n", SignalKind::active_low)),
        acknowledge(dump.add(bus.name, "DTACK_n", SignalKind::active_low)),
        error(dump.add(bus.name, "BERR_n", SignalKind::active_low)),
        write(dump.add(bus.name, "WRITE_n", SignalKind::vector)),
        address(dump.add(bus.name, "address", SignalKind::vector, k_address_bits)),
        data(dump.add(bus.name, "data", SignalKind::vector, bus.data_bits)),
        owner(dump.add(bus.name, "owner", SignalKind::vector, k_owner_bits)) {}

  // The number of the first of five.
  static std::uint16_t levels(VcdDump& dump, const std::string& scope, const char* name) {
    const auto first = static_cast<std::uint16_t>(dump.signals.size());
    for (int level = 0; level < k_levels; ++level) {
      dump.add(scope, fmt::format("{}{}_n", name, level), SignalKind::active_low);
    }
    return first;
  }

  std::uint16_t request;
  std::uint16_t grant;
  std::uint16_t busy;
  std::uint16_t address_strobe;
  std::uint16_t data_strobe;
  std::uint16_t acknowledge;
  std::uint16_t error;
  std::uint16_t write;
  std::uint16_t address;
  std::uint16_t data;
  std::uint16_t owner;
};

void dump_access(VcdDump& dump, const BusSignals& bus, const RecordedAccess& access, int level) {
  const Instant end = access.end();
  dump.assert_during(after(bus.request, level), access.request, access.grant);
  dump.assert_during(after(bus.grant, level), access.decision(), access.grant);
  dump.assert_during(bus.busy, access.grant, end);
  dump.assert_during(bus.address_strobe, access.grant, end);
  dump.assert_during(bus.data_strobe, access.grant, end);
  dump.assert_during(access.is_answered() ? bus.acknowledge : bus.error,
                     access.grant + access.acknowledge, end);
  dump.set(bus.write, access.grant, access.write != 0 ? 0 : 1);
  dump.set(bus.address, access.grant, access.address);
  dump.set(bus.data, access.grant, access.data);
  dump.set(bus.owner, access.grant, access.board);
  for (const std::uint16_t lines : {bus.write, bus.address, bus.data, bus.owner}) {
    dump.release(lines, end);
  }
}

void dump_bus(VcdDump& dump, const BusRecord& record, const RecordedBus& bus) {
  const BusSignals signals(dump, bus);
  const auto level = [&record](std::size_t board) { return record.boards[board].level; };
  const RecordedAccess* before = nullptr;
  for (const RecordedAccess& access : bus.accesses) {
    if (access.is_kept() && before != nullptr) {
      dump.assert_during(signals.busy, before->end(), access.decision());
      dump.set(signals.owner, before->end(), before->board);
      dump.release(signals.owner, access.decision());
    }
    dump_access(dump, signals, access, level(access.board));
    before = &access;
  }
  for (const StandingRequest& standing : bus.standing) {
    dump.assert_during(after(signals.request, level(standing.board)), standing.request,
                       record.window.to);
  }
}

void dump_board(VcdDump& dump, const BusRecord& record, std::size_t board) {
  const std::string& scope = record.boards[board].name;
  const std::uint16_t state = dump.add(scope, scope + "_state", SignalKind::vector, k_state_bits);
  const std::uint16_t request = dump.add(scope, scope + "_BR_n", SignalKind::active_low);
  for (const StateInterval& interval : board_states(record, board)) {
    dump.set(state, interval.from, static_cast<std::uint32_t>(interval.state));
    if (interval.state == BoardState::wait_grant) {
      dump.assert_during(request, interval.from, interval.to);
    }
  }
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
  std::vector<std::uint32_t> counts_;  // of those that assert an active-low signal
  VcdText text_;
};

VcdDump dump_of(const BusRecord& record, const std::vector<std::size_t>& boards) {
  VcdDump dump;
  for (const RecordedBus& bus : record.buses) {
    dump_bus(dump, record, bus);
  }
  for (const std::size_t board : boards) {
    dump_board(dump, record, board);
  }
  if (record.video) {
    dump_video(*record.video, dump);
  }
  return dump;
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
  VcdDump dump = dump_of(record, boards);
  std::stable_sort(dump.changes.begin(), dump.changes.end(),
                   [](const SignalChange& a, const SignalChange& b) { return a.at < b.at; });

  VcdTrace trace(dump, stream);
  auto change = dump.changes.begin();
  const auto apply_until = [&](auto&& is_later) {
    for (; change != dump.changes.end() && !is_later(change->at); ++change) {
      trace.apply(*change);
    }
  };
  apply_until([&](Instant at) { return at > record.window.from; });
  trace.text().show_all(record.window.from);
  while (change != dump.changes.end() && change->at < record.window.to) {
    const Instant now = change->at;
    apply_until([now](Instant at) { return at > now; });
    trace.text().show_changes(now);
  }
  trace.text().end(record.window.to);
}

void write_gtkwave_view(const BusRecord& record, const std::vector<std::size_t>& boards,
                        const std::string& trace, std::ostream& stream) {
  TraceText text(stream);
  text.add("[dumpfile] \"{}\"\n[timestart] {}\n", trace, record.window.from.count());
  std::string scope;
  const auto close = [&] {
    if (!scope.empty()) {
      text.add("@1000200\n-{}\n", scope);
    }
  };
  for (const DumpedSignal& signal : dump_of(without_accesses(record), boards).signals) {
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
