#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace maquette::sim {

/// Exit code of a job that was interrupted before its end; as shells have it for SIGINT.
inline constexpr int k_job_interrupted = 130;

/// How the process of a job ended: with an exit code, or by what `crash` says.
struct JobEnd {
  int exit_code = 0;
  std::string crash;
};

/// What runs jobs in processes of their own.
struct ForkedJobs {
  std::size_t count = 0;
  int processes = 1;  ///< at a time, at least 1

  /// Runs in a process of its own and gives its exit code; must not throw.
  std::function<int(std::size_t job)> run;

  /// Called here when a job's process is gone.
  std::function<void(std::size_t job, const JobEnd& end)> ended;
};

/// Runs all jobs, in their order. Every job sees the memory of this process as it is now and may
/// change none of it; this process must have no other threads. When an interruption is requested
/// (interruption.hpp, whose handler the jobs inherit) no further job starts, the running ones are
/// asked to end (SIGTERM), and `ended` is not called for those that do. Returns whether all jobs
/// have ended. Throws std::runtime_error when no process can be made.
bool run_forked(const ForkedJobs& jobs);

}  // namespace maquette::sim
