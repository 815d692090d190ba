#include "sim/report/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

constexpr const char* k_clear_line = "\r\033[K";

std::string bar(double fraction) {
  constexpr std::size_t width = 24;
  const auto filled = static_cast<std::size_t>(fraction * width);
  return std::string(filled, '#') + std::string(width - filled, '.');
}

std::string clock_time(double time_s) {
  const auto whole = static_cast<long>(time_s);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string progress_line(models::Duration simulated, double fraction, double host_time_s) {
  fraction = std::clamp(fraction, 0.0, 1.0);
  std::string line = fmt::format("[{}] {:3.0f} %  {} simulated", bar(fraction), 100 * fraction,
                                 readable_duration(simulated));
  if (host_time_s > 0) {
    line += fmt::format(", {:.0f} times real time", in_seconds(simulated) / host_time_s);
  }
  if (fraction > 0) {
    line += fmt::format(", {} left", clock_time(host_time_s * (1 - fraction) / fraction));
  }
  return line;
}

Progress::Progress(bool wanted)
    : active_(wanted && ::isatty(STDERR_FILENO) == 1), start_(Clock::now()), next_(start_) {}

Progress::~Progress() {
  if (shown_) {
    std::fputs(k_clear_line, stderr);
  }
}

void Progress::show(models::Duration simulated, double fraction) {
  if (!active_) {
    return;
  }
  const auto now = Clock::now();
  if (now < next_) {
    return;
  }
  next_ = now + std::chrono::milliseconds(100);
  shown_ = true;
  const double host_time_s = std::chrono::duration<double>(now - start_).count();
  std::fputs((k_clear_line + progress_line(simulated, fraction, host_time_s)).c_str(), stderr);
}

}  // namespace maquette::sim
