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

std::string study_progress_line(int done, int failed, int planned, double host_time_s) {
  const double fraction = planned > 0 ? static_cast<double>(done) / planned : 1;
  std::string line = fmt::format("[{}] {} of {} points", bar(fraction), done, planned);
  line += failed > 0 ? fmt::format(", {} failed", failed) : "";
  if (host_time_s > 0 && done > 0) {
    line += fmt::format(", {:.3g} points/s, {} left", done / host_time_s,
                        clock_time(host_time_s * (1 - fraction) / fraction));
  }
  return line;
}

std::string check_progress_line(int done, int planned, const std::string& now, double host_time_s) {
  const double fraction = planned > 0 ? static_cast<double>(done) / planned : 1;
  return fmt::format("[{}] {} of {} checks, {}, now {}", bar(fraction), done, planned,
                     clock_time(host_time_s), now);
}

Progress::Progress(bool wanted)
    : active_(wanted && ::isatty(STDERR_FILENO) == 1), start_(Clock::now()), next_(start_) {}

Progress::~Progress() {
  if (shown_) {
    std::fputs(k_clear_line, stderr);
  }
}

void Progress::show(models::Duration simulated, double fraction) {
  if (is_due()) {
    write(progress_line(simulated, fraction, host_time_s()));
  }
}

void Progress::show_points(int done, int failed, int planned) {
  if (is_due()) {
    write(study_progress_line(done, failed, planned, host_time_s()));
  }
}

void Progress::show_checks(int done, int planned, const std::string& now) {
  if (is_due()) {
    write(check_progress_line(done, planned, now, host_time_s()));
  }
}

bool Progress::is_due() {
  const auto now = Clock::now();
  if (!active_ || now < next_) {
    return false;
  }
  next_ = now + std::chrono::milliseconds(100);
  return true;
}

void Progress::write(const std::string& line) {
  shown_ = true;
  std::fputs((k_clear_line + line).c_str(), stderr);
}

double Progress::host_time_s() const {
  return std::chrono::duration<double>(Clock::now() - start_).count();
}

}  // namespace maquette::sim
