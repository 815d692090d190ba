#include "sim/accuracy/level_run.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

#include "sim/accuracy/level_computation.hpp"
#include "sim/accuracy/outcome_bytes.hpp"
#include "sim/run/forked_jobs.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

constexpr int k_failed = 1;
constexpr int k_bad_input = 2;

/// A file without a name, through which the process of one level after the other hands over what
/// came of it.
using HandOver = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

HandOver make_hand_over() {
  HandOver file(std::tmpfile(), std::fclose);
  if (!file) {
    throw std::runtime_error("no temporary file can be made");
  }
  return file;
}

void hand_over(std::FILE* file, const std::string& bytes) {
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size() || std::fflush(file) != 0) {
    throw std::runtime_error("a temporary file cannot be written");
  }
}

/// What the last process has handed over, which makes room for the next.
std::string handed_over(std::FILE* file) {
  std::rewind(file);
  std::string bytes;
  char block[65536];
  for (std::size_t size = 0; (size = std::fread(block, 1, sizeof block, file)) > 0;) {
    bytes.append(block, size);
  }
  std::rewind(file);
  if (::ftruncate(::fileno(file), 0) != 0) {
    throw std::runtime_error("a temporary file cannot be emptied");
  }
  return bytes;
}

/// The whole life of a level's process.
int run_level(const LevelTask& task, bool with_tiles, std::FILE* file) {
  int exit_code = k_failed;
  std::string bytes;
  try {
    const std::optional<LevelOutcome> outcome = computed_level(task, with_tiles);
    if (!outcome) {
      return k_job_interrupted;
    }
    bytes = encode_outcome(*outcome);
    exit_code = 0;
  } catch (const DescriptionError& error) {
    bytes = error.what();
    exit_code = k_bad_input;
  } catch (const std::exception& error) {
    bytes = error.what();
  }
  try {
    hand_over(file, bytes);
  } catch (const std::exception&) {
    return k_failed;
  }
  return exit_code;
}

LevelOutcome outcome_of(const LevelTask& task, const JobEnd& end, std::FILE* file) {
  if (!end.crash.empty()) {
    throw std::runtime_error(fmt::format("level {}: its process was {}", task.name, end.crash));
  }
  const std::string bytes = handed_over(file);
  if (end.exit_code == k_bad_input) {
    throw DescriptionError(fmt::format("level {}: {}", task.name, bytes));
  }
  if (end.exit_code != 0) {
    throw std::runtime_error(fmt::format("level {}: {}", task.name, bytes));
  }
  return decode_outcome(bytes);
}

}  // namespace

std::vector<std::vector<LevelOutcome>> run_levels(const std::vector<LevelTask>& tasks, int repeats,
                                                  const std::function<void(int)>& show) {
  std::vector<std::vector<LevelOutcome>> outcomes(tasks.size());
  const HandOver file = make_hand_over();
  ForkedJobs jobs;
  jobs.count = tasks.size() * static_cast<std::size_t>(repeats);
  jobs.run = [&](std::size_t job) {
    return run_level(tasks[job % tasks.size()], job < tasks.size(), file.get());
  };
  jobs.ended = [&](std::size_t job, const JobEnd& end) {
    const std::size_t task = job % tasks.size();
    outcomes[task].push_back(outcome_of(tasks[task], end, file.get()));
    show(static_cast<int>(job) + 1);
  };
  if (!run_forked(jobs)) {
    return {};
  }
  return outcomes;
}

}  // namespace maquette::sim
