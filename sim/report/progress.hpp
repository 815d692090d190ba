#pragma once

#include <chrono>
#include <string>

#include "models/bus/duration.hpp"

namespace maquette::sim {

/// One line of progress: simulated time, `fraction` of the work done (0..1) as a bar, simulated
/// time per host time, host time left.
std::string progress_line(models::Duration simulated, double fraction, double host_time_s);

/// One line of progress of a study: points done of those planned, how many failed, points per host
/// time, host time left.
std::string study_progress_line(int done, int failed, int planned, double host_time_s);

/// One line of progress of a list of checks: how many are done of those planned, what is checked
/// now, host time so far.
std::string check_progress_line(int done, int planned, const std::string& now, double host_time_s);

/// The progress bar of a run or a study, on standard error while that is a terminal, and never in a
/// result.
class Progress {
 public:
  /// Stays silent unless `wanted` and standard error is a terminal.
  explicit Progress(bool wanted);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  Progress(Progress&&) = delete;
  Progress& operator=(Progress&&) = delete;
  ~Progress();  ///< clears the line

  /// Call as often as convenient: the terminal is written ten times a second at most.
  void show(models::Duration simulated, double fraction);
  void show_points(int done, int failed, int planned);
  void show_checks(int done, int planned, const std::string& now);

 private:
  using Clock = std::chrono::steady_clock;

  bool is_due();
  void write(const std::string& line);
  [[nodiscard]] double host_time_s() const;

  bool active_;
  bool shown_ = false;
  Clock::time_point start_;
  Clock::time_point next_;
};

}  // namespace maquette::sim
