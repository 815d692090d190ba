#include "sim/trace/chrome_trace.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "sim/report/seconds.hpp"
#include "sim/trace/board_states.hpp"
#include "sim/trace/trace_text.hpp"

namespace maquette::sim {

namespace {

using models::Duration;
using models::Instant;

constexpr int k_boards_process = 1;
constexpr int k_first_bus_process = 2;
constexpr int k_owner_thread = 1;

// Microseconds to the last tick, without closing zeros.
class Microseconds {
 public:
  explicit Microseconds(Instant instant) {
    constexpr std::int64_t k_per_microsecond = 1'000'000;
    const std::int64_t ticks = instant.count();
    char* end = fmt::format_to(text_.data(), "{}.{:06}", ticks / k_per_microsecond,
                               ticks % k_per_microsecond);
    while (end[-1] == '0') {
      --end;
    }
    end -= end[-1] == '.' ? 1 : 0;
    size_ = static_cast<std::size_t>(end - text_.data());
  }

  [[nodiscard]] std::string_view text() const { return {text_.data(), size_}; }

 private:
  std::array<char, 32> text_{};
  std::size_t size_ = 0;
};

const char* kind_of(const RecordedAccess& access) {
  if (access.is_test_and_set()) {
    return "test and set";
  }
  return access.write != 0 ? "write" : "read";
}

class ChromeTrace {
 public:
  ChromeTrace(const BusRecord& record, std::ostream& stream) : record_(record), text_(stream) {
    text_.add(R"({{"displayTimeUnit":"ns","otherData":{{"time":"simulated,)"
              R"( from the frame's start","window_from_s":"{}","window_to_s":"{}"}},)"
              R"("traceEvents":[)",
              format_seconds(record.window.from), format_seconds(record.window.to));
  }

  void finish() { text_.add("\n]}}\n"); }

  void name_process(int process, const std::string& name) {
    event(R"({{"ph":"M","name":"process_name","pid":{0},"args":{{"name":"{1}"}}}})", process, name);
    event(R"({{"ph":"M","name":"process_sort_index","pid":{0},)"
          R"("args":{{"sort_index":{0}}}}})",
          process);
  }

  void name_thread(int process, int thread, const std::string& name) {
    event(R"({{"ph":"M","name":"thread_name","pid":{},"tid":{},"args":{{"name":"{}"}}}})", process,
          thread, name);
    event(R"({{"ph":"M","name":"thread_sort_index","pid":{0},"tid":{1},)"
          R"("args":{{"sort_index":{1}}}}})",
          process, thread);
  }

  void board(std::size_t number) {
    const int thread = thread_of(number);
    name_thread(
        k_boards_process, thread,
        fmt::format("{} (level {})", record_.boards[number].name, record_.boards[number].level));
    for (const StateInterval& interval : board_states(record_, number)) {
      event(R"({{"ph":"B","name":"{}","ts":{},"pid":{},"tid":{}}})", name_of(interval.state),
            Microseconds(interval.from).text(), k_boards_process, thread);
      close(interval.to, k_boards_process, thread);
    }
  }

  void owner(const RecordedBus& bus, int process) {
    name_thread(process, k_owner_thread, "owner");
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
        event(R"({{"ph":"C","name":"queue length","ts":{},"pid":{},"args":{{"requests":{}}}}})",
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
        event(R"({{"ph":"C","name":"{}","ts":{},"pid":{},"args":{{"busy":{}}}}})", name,
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
        flow('s', access.request, {k_boards_process, thread_of(access.board)});
        flow('f', access.grant, {process, k_owner_thread});
      }
    }
  }

 private:
  static int thread_of(std::size_t board) { return static_cast<int>(board) + 1; }

  template <typename... Values>
  void event(fmt::format_string<Values...> format, Values&&... values) {
    text_.add("{}", first_ ? "\n" : ",\n");
    text_.add(format, std::forward<Values>(values)...);
    first_ = false;
  }

  void close(Instant instant, int process, int thread) {
    event(R"({{"ph":"E","ts":{},"pid":{},"tid":{}}})", Microseconds(instant).text(), process,
          thread);
  }

  void own(const RecordedAccess& access, int process) {
    const Instant from = record_.window.clip(access.grant);
    const Instant to = record_.window.clip(access.end());
    if (from < to) {
      event(R"({{"ph":"B","name":"{}","ts":{},"pid":{},"tid":{},"args":{{"{}":"0x{:06x}",)"
            R"("data":"0x{:04x}"{}}}}})",
            record_.boards[access.board].name, Microseconds(from).text(), process, k_owner_thread,
            kind_of(access), access.address, access.data,
            access.is_answered() ? "" : R"(,"bus error":true)");
      close(to, process, k_owner_thread);
    }
  }

  void keep(const RecordedAccess& keeper, Instant from, Instant to, int process) {
    from = record_.window.clip(from);
    to = record_.window.clip(to);
    if (from < to) {
      event(R"({{"ph":"B","name":"kept by {}","ts":{},"pid":{},"tid":{}}})",
            record_.boards[keeper.board].name, Microseconds(from).text(), process, k_owner_thread);
      close(to, process, k_owner_thread);
    }
  }

  struct Track {
    int process;
    int thread;
  };

  void flow(char phase, Instant instant, Track track) {
    event(R"({{"ph":"{}","name":"grant","cat":"bus","id":{},"ts":{},"pid":{},)"
          R"("tid":{}{}}})",
          phase, flows_, Microseconds(instant).text(), track.process, track.thread,
          phase == 'f' ? R"(,"bp":"e")" : "");
  }

  const BusRecord& record_;
  TraceText text_;
  bool first_ = true;
  std::int64_t flows_ = 0;
};

}  // namespace

void write_chrome_trace(const BusRecord& record, const std::vector<std::size_t>& boards,
                        std::ostream& stream) {
  ChromeTrace trace(record, stream);
  trace.name_process(k_boards_process, "boards");
  for (const std::size_t board : boards) {
    trace.board(board);
  }
  int process = k_first_bus_process;
  for (const RecordedBus& bus : record.buses) {
    trace.name_process(process, bus.name);
    trace.owner(bus, process);
    trace.queue(bus, process);
    trace.utilisation(bus, process);
    trace.flows(bus, process, boards);
    ++process;
  }
  trace.finish();
}

// Measured on whole frames.
std::int64_t expected_chrome_trace_bytes(const BusRecord& record) {
  return expected_bytes(record, 530, 390);
}

}  // namespace maquette::sim
