#include "sim/sweep/study_run.hpp"

#include <fmt/format.h>
#include <algorithm>

#include <exception>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "firmware/arithmetic/stop_request.hpp"
#include "sim/report/remark.hpp"
#include "sim/run/forked_jobs.hpp"
#include "sim/run/frame_recorder.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/record_store.hpp"
#include "sim/run/simulation.hpp"

namespace maquette::sim {

namespace {

/// Exit code of a point's process that has stored why the point failed.
constexpr int k_failure_stored = 3;

/// What the points of a batch have in common: the frame that they replay, and what its counted work
/// costs, by its key.
struct SharedWork {
  std::optional<RecordedFrame> record;
  std::map<std::string, Calibration> calibrations;
};

/// Nothing when the run was interrupted.
std::optional<PointResult> simulate_point(const Description& description,
                                          const SharedWork& shared) {
  SimulationRequest request;
  request.record = shared.record ? &*shared.record : nullptr;
  const auto calibration = shared.calibrations.find(calibration_key(description.machine));
  request.calibration = calibration == shared.calibrations.end() ? nullptr : &calibration->second;
  request.picture = false;
  try {
    const SimulationResult result =
        simulate(description.scene, description.machine, request,
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
int run_point(const StudyPoints& points, const StudyDirectory& directory, int point,
              const SharedWork& shared) {
  try {
    const std::optional<PointResult> result = simulate_point(points.description(point), shared);
    if (!result) {
      return k_job_interrupted;
    }
    directory.write(point, *result);
    return result->statistics ? 0 : k_failure_stored;
  } catch (const std::exception& error) {
    remark(fmt::format("maquette: point {}: {}\n", point, error.what()));
    return 1;
  }
}

std::string crash_of(const JobEnd& end) {
  return end.crash.empty() ? fmt::format("its process ended with exit code {}", end.exit_code)
                           : fmt::format("its process was {}", end.crash);
}

/// Points that are run one after another: those that share a record, or those that share none.
struct Batch {
  std::vector<int> numbers;
  bool has_record = false;
};

std::vector<Batch> batches_of(const std::vector<std::string>& records,
                              const std::vector<int>& numbers) {
  std::map<std::string, std::vector<int>> sharing;
  for (const int number : numbers) {
    sharing[records[static_cast<std::size_t>(number)]].push_back(number);
  }
  std::vector<Batch> batches(1);
  for (auto& [name, sharers] : sharing) {
    if (sharers.size() > 1) {
      batches.push_back({std::move(sharers), true});
    } else {
      batches.front().numbers.push_back(sharers.front());
    }
  }
  return batches;
}

/// Calibrates for a machine unless that has been done for one like it.
void calibrate_for(const Description& description, SharedWork& shared) {
  if (!is_calibrated(description.machine)) {
    return;
  }
  const std::string key = calibration_key(description.machine);
  if (shared.calibrations.count(key) == 0) {
    shared.calibrations.emplace(key, calibrate(description.scene, description.machine));
  }
}

/// Done once for all points of a batch that share a scene. On a single thread of the host, since
/// this process must stay fit to fork.
SharedWork shared_work_of(const StudyPoints& points, const Batch& batch) {
  SharedWork shared;
  if (!batch.has_record) {
    return shared;
  }
  const Description first = points.description(batch.numbers.front());
  LegsOfPixels legs = LegsOfPixels::untold;
  for (const int number : batch.numbers) {
    const Description description = points.description(number);
    calibrate_for(description, shared);
    legs = std::max(legs, legs_wanted(description.machine));
  }
  shared.record = record_frame(first.scene, picture_format_of(first.machine), 1,
                               FunctionsOfPixels::untold, legs);
  return shared;
}

}  // namespace

std::vector<std::string> check_points(const StudyPoints& points) {
  std::vector<std::string> records;
  for (int point = 0; point < points.size(); ++point) {
    const Description description = points.description(point);
    check_fit(description.scene, description.machine);
    records.push_back(record_key_of(description.scene, description.machine).name());
  }
  return records;
}

StudyProgress run_points(const StudyPoints& points, const StudyDirectory& directory,
                         const std::vector<std::string>& records, const std::vector<int>& numbers,
                         int processes, const std::function<void(const StudyProgress&)>& show) {
  StudyProgress progress;
  progress.planned = static_cast<int>(numbers.size());
  for (const Batch& batch : batches_of(records, numbers)) {
    const std::optional<SharedWork> shared = firmware::unless_stopped(
        [&] { return std::optional<SharedWork>(shared_work_of(points, batch)); },
        std::optional<SharedWork>());
    if (!shared) {
      break;
    }
    ForkedJobs jobs;
    jobs.count = batch.numbers.size();
    jobs.processes = processes;
    jobs.run = [&](std::size_t job) {
      return run_point(points, directory, batch.numbers[job], *shared);
    };
    jobs.ended = [&](std::size_t job, const JobEnd& end) {
      if (end.exit_code != 0 && end.exit_code != k_failure_stored) {
        directory.write(batch.numbers[job], {std::nullopt, crash_of(end)});
      }
      ++progress.done;
      progress.failed += end.exit_code == 0 ? 0 : 1;
      show(progress);
    };
    if (!run_forked(jobs)) {
      break;
    }
  }
  return progress;
}

}  // namespace maquette::sim
