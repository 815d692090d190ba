#include "sim/trace/chrome_trace.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "sim/report/seconds.hpp"
#include "sim/trace/board_states.hpp"
#include "sim/trace/chrome_events.hpp"
#include "sim/trace/chrome_video.hpp"

namespace maquette::sim {

namespace {

using models::Duration;
using models::Instant;

constexpr int k_boards_process = 1;
constexpr int k_first_bus_process = 2;
constexpr int k_owner_thread = 1;

const char* kind_of(const RecordedAccess& access) {
  if (access.is_test_and_set()) {
    return "test and set";
  }
  return access.write != 0 ? "write" : "read";
}

class ChromeTrace {
 public:
  ChromeTrace(const BusRecord& record, ChromeEvents& events) : record_(record), events_(events) {}

  void board(std::size_t number) {
    const ChromeTrack track = track_of(number);
    events_.name_thread(track, fmt::format("{} (level {})", record_.boards[number].name,
                                           record_.boards[number].level));
    for (const StateInterval& interval : board_states(record_, number)) {
      events_.slice(track, name_of(interval.state), interval.from, interval.to);
    }
  }

  void owner(const RecordedBus& bus, int process) {
    events_.name_thread({process, k_owner_thread}, "owner");
    Instant released = record_.window.from;
    const RecordedAccess* before = nullptr;
    for (const RecordedAccess& access : bus.accesses) {
      if (access.is_kept() && before != nullptr) {
        keep(*before, released, access.decision(), process);
      }
      own(access, process);
      released = access.end();
      before = &access;
    }
  }

  void queue(const RecordedBus& bus, int process) {
    std::vector<std::pair<Instant, int>> changes{{record_.window.from, 0}};
    for (const RecordedAccess& access : bus.accesses) {
      changes.emplace_back(record_.window.clip(access.request), 1);
      changes.emplace_back(record_.window.clip(access.grant), -1);
    }
    for (const StandingRequest& standing : bus.standing) {
      changes.emplace_back(record_.window.clip(standing.request), 1);
    }
    std::sort(changes.begin(), changes.end());
    int length = 0;
    int shown = -1;
    for (std::size_t i = 0; i < changes.size() && changes[i].first < record_.window.to; ++i) {
      length += changes[i].second;
      const bool last_of_instant =
          i + 1 == changes.size() || changes[i + 1].first != changes[i].first;
      if (last_of_instant && length != shown) {
        events_.event(
            R"({{"ph":"C","name":"queue length","ts":{},"pid":{},"args":{{"requests":{}}}}})",
            Microseconds(changes[i].first).text(), process, length);
        shown = length;
      }
    }
  }

  void utilisation(const RecordedBus& bus, int process) {
    const TraceWindow& window = record_.window;
    const std::string name =
        fmt::format("utilisation over {}", readable_duration(k_utilisation_step));
    auto access = bus.accesses.begin();
    double shown = -1;
    for (Instant start = window.from; start < window.to;) {
      const Instant end =
          std::min(window.to, k_utilisation_step * (start / k_utilisation_step + 1));
      Duration busy{};
      for (; access != bus.accesses.end() && access->grant < end; ++access) {
        busy += std::max(std::min(access->end(), end) - std::max(access->grant, start),
                         Duration::zero());
        if (access->end() > end) {
          break;
        }
      }
      const double share =
          static_cast<double>(busy.count()) / static_cast<double>((end - start).count());
      if (share != shown) {
        events_.event(R"({{"ph":"C","name":"{}","ts":{},"pid":{},"args":{{"busy":{}}}}})", name,
                      Microseconds(start).text(), process, share);
        shown = share;
      }
      start = end;
    }
  }

  /// Arrows of the boards from their requests to their grants, where both are in the window.
  void flows(const RecordedBus& bus, int process, const std::vector<std::size_t>& boards) {
    const TraceWindow& window = record_.window;
    for (const RecordedAccess& access : bus.accesses) {
      if (access.request < access.grant && access.request >= window.from &&
          access.grant < window.to &&
          std::binary_search(boards.begin(), boards.end(), std::size_t{access.board})) {
        ++flows_;
        flow('s', "grant", access.request, track_of(access.board));
        flow('f', "grant", access.grant, {process, k_owner_thread});
      }
    }
  }

  /// Arrows of what is handed over, from the request of a message to its end.
  void handovers(const std::vector<std::size_t>& boards) {
    const auto is_shown = [&boards](std::size_t board) {
      return std::binary_search(boards.begin(), boards.end(), board);
    };
    for (const RecordedHandover& handover : record_.handovers) {
      if (is_shown(handover.from) && is_shown(handover.to)) {
        ++flows_;
        flow('s', "errand", handover.sent, track_of(handover.from));
        flow('f', "errand", handover.arrived, track_of(handover.to));
      }
    }
  }

 private:
  static ChromeTrack track_of(std::size_t board) {
    return {k_boards_process, static_cast<int>(board) + 1};
  }

  void own(const RecordedAccess& access, int process) {
    const Instant from = record_.window.clip(access.grant);
    const Instant to = record_.window.clip(access.end());
    if (from < to) {
      events_.slice({process, k_owner_thread}, record_.boards[access.board].name, from, to,
                    fmt::format(R"(,"args":{{"{}":"0x{:06x}","data":"0x{:04x}"{}}})",
                                kind_of(access), access.address, access.data,
                                access.is_answered() ? "" : R"(,"bus error":true)"));
    }
  }

  void keep(const RecordedAccess& keeper, Instant from, Instant to, int process) {
    from = record_.window.clip(from);
    to = record_.window.clip(to);
    if (from < to) {
      events_.slice({process, k_owner_thread}, "kept by " + record_.boards[keeper.board].name, from,
                    to);
    }
  }

  void flow(char phase, const char* name, Instant instant, const ChromeTrack& track) {
    events_.event(R"({{"ph":"{}","name":"{}","cat":"bus","id":{},"ts":{},"pid":{},)"
                  R"("tid":{}{}}})",
                  phase, name, flows_, Microseconds(instant).text(), track.process, track.thread,
                  phase == 'f' ? R"(,"bp":"e")" : "");
  }

  const BusRecord& record_;
  ChromeEvents& events_;
  std::int64_t flows_ = 0;
};

}  // namespace

void write_chrome_trace(const BusRecord& record, const std::vector<std::size_t>& boards,
                        std::ostream& stream) {
  ChromeEvents events(record.window, stream);
  ChromeTrace trace(record, events);
  events.name_process(k_boards_process, "boards");
  for (const std::size_t board : boards) {
    trace.board(board);
  }
  trace.handovers(boards);
  int process = k_first_bus_process;
  for (const RecordedBus& bus : record.buses) {
    events.name_process(process, bus.name);
    trace.owner(bus, process);
    trace.queue(bus, process);
    trace.utilisation(bus, process);
    trace.flows(bus, process, boards);
    ++process;
  }
  if (record.video) {
    add_video(*record.video, process, events);
  }
  events.finish();
}

// Measured on whole frames.
std::int64_t expected_chrome_trace_bytes(const BusRecord& record) {
  constexpr std::int64_t k_per_handover = 180;
  return expected_bytes(record, 530, 390, 130) +
         k_per_handover * static_cast<std::int64_t>(record.handovers.size());
}

}  // namespace maquette::sim
