#pragma once

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

#include "sim/trace/bus_record.hpp"
#include "sim/trace/trace_text.hpp"

namespace maquette::sim {

/// An instant in microseconds to the last tick, without closing zeros.
class Microseconds {
 public:
  explicit Microseconds(models::Instant instant) {
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

/// A thread of a process of a trace, as its events name it.
struct ChromeTrack {
  int process;
  int thread;
};

/// The events of a trace in Chrome's format, on their way to a stream.
class ChromeEvents {
 public:
  ChromeEvents(const TraceWindow& window, std::ostream& stream);

  void finish() { text_.add("\n]}}\n"); }

  void name_process(int process, const std::string& name);
  void name_thread(const ChromeTrack& track, const std::string& name);

  /// A slice; `arguments` are those of its first event, from the comma on.
  void slice(const ChromeTrack& track, const std::string& name, models::Instant from,
             models::Instant to, const std::string& arguments = {});

  template <typename... Values>
  void event(fmt::format_string<Values...> format, Values&&... values) {
    text_.add("{}", first_ ? "\n" : ",\n");
    text_.add(format, std::forward<Values>(values)...);
    first_ = false;
  }

 private:
  TraceText text_;
  bool first_ = true;
};

}  // namespace maquette::sim
