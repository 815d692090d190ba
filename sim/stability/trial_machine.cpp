#include "sim/stability/trial_machine.hpp"

#include <sys/mman.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <systemc>
#include <thread>

#include "models/machine/ccett_machine.hpp"
#include "sim/machine/machine_description.hpp"
#include "sim/run/forked_jobs.hpp"
#include "sim/run/frame_statistics.hpp"

namespace maquette::sim {

namespace {

constexpr int k_width = 64;
constexpr int k_height = 48;

class TrialPixels : public models::PixelSource {
 public:
  explicit TrialPixels(const TrialMachine& trial)
      : work_(trial.work),
        allotment_(trial.machine.parameters.allotment, trial.zone,
                   static_cast<int>(trial.machine.parameters.boards.size())) {}

  const models::SynthesizedPixel& pixel(std::int64_t index) override {
    const models::PixelPosition position = allotment_.position(index);
    pixel_.column = static_cast<std::uint16_t>(position.column);
    pixel_.row = static_cast<std::uint16_t>(position.row);
    pixel_.work[firmware::Operation::node] = work_(index);
    return pixel_;
  }

  [[nodiscard]] firmware::Work preprocessing() const override { return {}; }

 private:
  models::SynthesizedPixel pixel_{};
  const std::function<std::uint32_t(std::int64_t)>& work_;
  models::PixelAllotment allotment_;
};

/// Memory that processes share.
class SharedOutcomes {
 public:
  explicit SharedOutcomes(std::size_t count)
      : bytes_(std::max<std::size_t>(count, 1) * sizeof(TrialOutcome)),
        memory_(
            ::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
    if (memory_ == MAP_FAILED) {
      throw std::bad_alloc();
    }
    std::uninitialized_fill_n(first(), count, TrialOutcome{});
  }
  SharedOutcomes(const SharedOutcomes&) = delete;
  SharedOutcomes& operator=(const SharedOutcomes&) = delete;
  SharedOutcomes(SharedOutcomes&&) = delete;
  SharedOutcomes& operator=(SharedOutcomes&&) = delete;
  ~SharedOutcomes() { ::munmap(memory_, bytes_); }

  [[nodiscard]] TrialOutcome* first() const { return static_cast<TrialOutcome*>(memory_); }

 private:
  std::size_t bytes_;
  void* memory_;
};

void set_message(const std::string& message, TrialOutcome& outcome) {
  const std::size_t length = std::min(message.size(), sizeof outcome.message - 1);
  std::memcpy(outcome.message, message.data(), length);
  outcome.message[length] = '\0';
}

std::int64_t lost_pixels(const models::FrameMemory& memory, const models::PixelRectangle& zone) {
  std::int64_t lost = 0;
  for (int row = 0; row < k_height; ++row) {
    for (int column = 0; column < k_width; ++column) {
      const bool useful = column >= zone.column0 && column < zone.column0 + zone.width &&
                          row >= zone.row0 && row < zone.row0 + zone.height;
      lost += useful == memory.written_once(column, row) && useful != memory.untouched(column, row)
                  ? 0
                  : 1;
    }
  }
  return lost;
}

/// Statistics as a run has them: their sums are checked.
void take_statistics(const models::MachineStatistics& model, const TrialMachine& trial,
                     TrialOutcome& outcome) {
  const Statistics statistics = frame_statistics(model, trial.machine, trial.zone, {});
  outcome.has_finished = model.has_finished;
  outcome.frame_time = model.frame_time;
  models::Duration queued{};
  for (const QueueTime& time : statistics.bus.queue.times) {
    queued += time.time;
  }
  outcome.disorders += queued == model.frame_time * model.backplanes ? 0 : 1;
  const bool overlaps = !trial.machine.parameters.bus.level.is_exclusive;
  outcome.disorders += statistics.frame.imbalance >= 0 ? 0 : 1;
  outcome.disorders += statistics.bus.utilisation <= 1 || overlaps ? 0 : 1;
  outcome.longest_wait = statistics.bus.longest_wait.time;
  outcome.longest_waiting = models::longest_waiting_master(model.bus);
}

void simulate(const TrialMachine& trial, TrialOutcome& outcome) {
  static_cast<void>(read_machine(write_machine(trial.machine)));
  TrialPixels pixels(trial);
  models::FrameSetup setup;
  setup.useful_zone = trial.zone;
  models::CcettMachine model("machine", trial.machine.parameters, pixels, setup);
  models::Instant end{};
  const bool is_in_order =
      model.backplanes() == 1 && trial.machine.parameters.bus.level.is_exclusive;
  model.observe_bus([&](const models::BusAccess& access) {
    outcome.disorders += access.grant >= end && access.end > access.grant ? 0 : 1;
    end = is_in_order ? access.end : models::Instant{};
  });
  sc_core::sc_start();
  take_statistics(model.statistics(), trial, outcome);
  outcome.lost_pixels = lost_pixels(model.frame_memory(), trial.zone);
}

int run_trial(const TrialMachine& trial, int limit_s, TrialOutcome& outcome) {
  const auto limit = static_cast<rlim_t>(limit_s);
  const rlimit limits{limit, limit + 1};
  ::setrlimit(RLIMIT_CPU, &limits);
  try {
    simulate(trial, outcome);
  } catch (const std::exception& error) {
    set_message(error.what(), outcome);
  }
  return 0;
}

}  // namespace

TrialMachine trial_machine(int boards, const models::PixelRectangle& zone) {
  TrialMachine trial{default_machine(), zone, [](std::int64_t) { return 0U; }};
  trial.machine.name = "trial";
  trial.machine.tables.arithmetic = "free";
  trial.machine.tables.program = "free";
  trial.machine.cost_origin = CostOrigin::tables;
  for (CostSource& source : trial.machine.tables.sources) {
    source.text = "a trial";
  }
  models::MachineParameters& parameters = trial.machine.parameters;
  parameters.boards.clear();
  for (int board = 0; board < boards; ++board) {
    parameters.boards.push_back({0, board});
  }
  constexpr auto k_node = static_cast<std::size_t>(firmware::Operation::node);
  parameters.board.arithmetic.operations[k_node].clocks = 1;
  parameters.board.refresh_period = models::Duration::zero();
  parameters.board.word_gap_clocks = 0;
  parameters.frame_memory.width = k_width;
  parameters.frame_memory.height = k_height;
  parameters.frame_memory.video_priority = false;
  return trial;
}

std::vector<TrialOutcome> run_trials(const std::vector<TrialMachine>& trials, int limit_s) {
  const SharedOutcomes outcomes(trials.size());
  ForkedJobs jobs;
  jobs.count = trials.size();
  jobs.processes = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  jobs.run = [&](std::size_t job) {
    return run_trial(trials[job], limit_s, outcomes.first()[job]);
  };
  jobs.ended = [&](std::size_t job, const JobEnd& end) {
    if (end.exit_code != 0) {
      set_message("its process was " + end.crash, outcomes.first()[job]);
    }
  };
  run_forked(jobs);
  return {outcomes.first(), outcomes.first() + trials.size()};
}

}  // namespace maquette::sim
