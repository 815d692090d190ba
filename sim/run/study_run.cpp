#include "sim/run/study_run.hpp"

#include <fmt/format.h>

#include <exception>
#include <optional>
#include <string>

#include "sim/run/forked_jobs.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/simulation.hpp"

namespace maquette::sim {

namespace {

/// Exit code of a point's process that has stored why the point failed.
constexpr int k_failure_stored = 3;

/// Nothing when the run was interrupted.
std::optional<PointResult> simulate_point(const Description& description) {
  try {
    const SimulationResult result =
        simulate(description.scene, description.machine, SimulationRequest{},
                 [](models::Duration, double) { return !Interruption::is_requested(); });
    if (result.statistics.partial) {
      return std::nullopt;
    }
    return PointResult{result.statistics, ""};
  } catch (const std::exception& error) {
    return PointResult{std::nullopt, error.what()};
  }
}

/// The whole life of a point's process.
int run_point(const StudyPoints& points, const StudyDirectory& directory, int point) {
  try {
    const std::optional<PointResult> result = simulate_point(points.description(point));
    if (!result) {
      return k_job_interrupted;
    }
    directory.write(point, *result);
    return result->statistics ? 0 : k_failure_stored;
  } catch (const std::exception& error) {
    fmt::print(stderr, "maquette: point {}: {}\n", point, error.what());
    return 1;
  }
}

std::string crash_of(const JobEnd& end) {
  return end.crash.empty() ? fmt::format("its process ended with exit code {}", end.exit_code)
                           : fmt::format("its process was {}", end.crash);
}

}  // namespace

void check_points(const StudyPoints& points) {
  for (int point = 0; point < points.size(); ++point) {
    const Description description = points.description(point);
    check_fit(description.scene, description.machine);
  }
}

StudyProgress run_points(const StudyPoints& points, const StudyDirectory& directory,
                         const std::vector<int>& numbers, int processes,
                         const std::function<void(const StudyProgress&)>& show) {
  StudyProgress progress;
  progress.planned = static_cast<int>(numbers.size());
  ForkedJobs jobs;
  jobs.count = numbers.size();
  jobs.processes = processes;
  jobs.run = [&](std::size_t job) { return run_point(points, directory, numbers[job]); };
  jobs.ended = [&](std::size_t job, const JobEnd& end) {
    if (end.exit_code != 0 && end.exit_code != k_failure_stored) {
      directory.write(numbers[job], {std::nullopt, crash_of(end)});
    }
    ++progress.done;
    progress.failed += end.exit_code == 0 ? 0 : 1;
    show(progress);
  };
  run_forked(jobs);
  return progress;
}

}  // namespace maquette::sim
