#include "sim/accuracy/level_computation.hpp"

#include <cmath>
#include <ctime>

#include "sim/database/frame_synthesis.hpp"
#include "sim/report/seconds.hpp"
#include "sim/run/calibration.hpp"
#include "sim/run/frame_recorder.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/pixel_sample.hpp"
#include "sim/run/simulation.hpp"

namespace maquette::sim {

namespace {

double processor_time_s() {
  return static_cast<double>(std::clock()) / static_cast<double>(CLOCKS_PER_SEC);
}

/// What `compute` gives, with the processor time that it took.
template <class Compute>
LevelOutcome timed(Compute compute) {
  const double start = processor_time_s();
  LevelOutcome outcome = compute();
  outcome.host_time_s = processor_time_s() - start;
  return outcome;
}

template <class Real>
LevelOutcome picture_alone(const LevelTask& task) {
  const PreparedScene<Real> scene(packed_scene<Real>(task.scene, picture_format_of(task.machine)));
  LevelOutcome outcome;
  outcome.picture = synthesized_frame(scene).picture;
  return outcome;
}

void set_frame(const Machine& machine, models::Duration frame, SimulatedTimes& times) {
  const auto boards = static_cast<double>(machine.parameters.boards.size());
  times.frame = frame;
  times.processor_clocks = boards * in_seconds(frame) * machine.parameters.board.clock_hz;
}

LevelOutcome simulated(const LevelTask& task, const Machine& machine,
                       const SimulationRequest& request) {
  const SimulationResult result =
      simulate(task.scene, machine, request,
               [](models::Duration, double) { return !Interruption::is_requested(); });
  LevelOutcome outcome;
  outcome.picture = result.picture;
  outcome.simulated.emplace();
  set_frame(machine, result.statistics.frame.time, *outcome.simulated);
  for (const BoardStatistics& board : result.statistics.boards) {
    outcome.simulated->waits.push_back(board.wait_grant);
  }
  return outcome;
}

/// The level's machine with what its counted work costs: that of executed pixels, where it leaves
/// it to them.
Machine priced_machine(const LevelTask& task) {
  Machine priced = task.machine;
  if (is_calibrated(priced)) {
    priced = with_costs(priced, calibrate(task.scene, priced));
    priced.cost_origin = CostOrigin::tables;
  }
  return priced;
}

LevelOutcome counted(const LevelTask& task, Machine& priced) {
  return timed([&] {
    priced = priced_machine(task);
    return simulated(task, priced, {});
  });
}

LevelOutcome replayed(const LevelTask& task) {
  const RecordedFrame record = record_frame(task.scene, picture_format_of(task.machine), 1,
                                            FunctionsOfPixels::untold, legs_wanted(task.machine));
  SimulationRequest request;
  request.record = &record;
  return timed([&] { return simulated(task, task.machine, request); });
}

LevelOutcome executed(const LevelTask& task) {
  SimulationRequest request;
  request.executed = true;
  return timed([&] { return simulated(task, task.machine, request); });
}

// Assumption: the frame's time is to the counted one as the time of the sample, and the host's is
// that of the sample times the share.
LevelOutcome executed_in_part(const LevelTask& task) {
  const int share = task.level.share;
  const Machine priced = priced_machine(task);
  LevelOutcome counted = simulated(task, priced, {});
  LevelOutcome outcome = timed([&] {
    LevelOutcome sample;
    sample.picture = std::move(counted.picture);
    sample.tiles = executed_tile_times(task.scene, task.machine, share, sample.picture);
    return sample;
  });
  const models::PixelRectangle& zone = outcome.tiles->grid.zone;
  outcome.host_time_s *= pixel_sample(task.machine, zone, share).step;
  const TileTimes counted_tiles = counted_tile_times(task.scene, priced, share);
  const double ratio =
      zone.pixels() > 0 ? in_seconds(outcome.tiles->sum()) / in_seconds(counted_tiles.sum()) : 1;
  const auto frame = static_cast<double>(counted.simulated->frame.count());
  outcome.simulated.emplace();
  set_frame(task.machine, models::Duration(std::llround(frame * ratio)), *outcome.simulated);
  return outcome;
}

/// `priced` becomes the machine at whose costs the level's work was counted, if it was.
LevelOutcome outcome_of(const LevelTask& task, Machine& priced) {
  switch (task.level.kind) {
    case LevelKind::float_picture:
      return timed([&] { return picture_alone<float>(task); });
    case LevelKind::double_picture:
      return timed([&] { return picture_alone<double>(task); });
    case LevelKind::recorded:
      return replayed(task);
    case LevelKind::executed:
      return task.level.share > 1 ? executed_in_part(task) : executed(task);
    case LevelKind::simulation:
      break;
  }
  return counted(task, priced);
}

TileTimes tile_times(const LevelTask& task, const Machine& priced, models::Picture& picture) {
  const int share = task.level.share;
  switch (task.level.kind) {
    case LevelKind::executed:
      return executed_tile_times(task.scene, task.machine, share, picture);
    case LevelKind::simulation:
    case LevelKind::recorded:
    case LevelKind::float_picture:
    case LevelKind::double_picture:
      break;
  }
  return counted_tile_times(task.scene, priced, share);
}

}  // namespace

std::optional<LevelOutcome> computed_level(const LevelTask& task, bool with_tiles) {
  Machine priced = task.machine;
  LevelOutcome outcome = outcome_of(task, priced);
  if (with_tiles && task.level.share > 0 && !outcome.tiles && !Interruption::is_requested()) {
    outcome.tiles = tile_times(task, priced, outcome.picture);
  }
  return Interruption::is_requested() ? std::nullopt : std::optional(std::move(outcome));
}

}  // namespace maquette::sim
