#include "sim/run/frame_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "models/bus/wide.hpp"
#include "sim/run/contention_statistics.hpp"
#include "sim/run/units_statistics.hpp"

namespace maquette::sim {

namespace {

BoardStatistics board_statistics(const models::BoardStatistics& board, std::size_t number,
                                 models::Duration frame_time) {
  BoardStatistics result;
  result.name = fmt::format("board{}", number);
  result.pixels = board.pixels;
  result.compute = board.compute;
  result.wait_grant = board.wait_grant;
  result.transfer = board.transfer;
  result.idle = board.idle;
  result.claim = board.claiming;
  result.claims = board.claims;
  result.claim_failed_tries = board.failed_tries;
  if (board.compute + board.wait_grant + board.transfer + board.wait_unit + board.idle !=
      frame_time) {
    throw std::logic_error(result.name + "'s states do not sum to the frame time");
  }
  return result;
}

void add_totals(const models::WorkTotals& totals, Statistics& statistics) {
  for (std::size_t i = 0; i < statistics.work.size(); ++i) {
    statistics.work[i] += totals.operations[i];
  }
  statistics.rays.primary += static_cast<std::int64_t>(totals.primary);
  statistics.rays.reflected += static_cast<std::int64_t>(totals.reflected);
  statistics.rays.refracted += static_cast<std::int64_t>(totals.refracted);
  statistics.rays.shadow += static_cast<std::int64_t>(totals.shadow);
  statistics.rays.total += static_cast<std::int64_t>(totals.primary + totals.reflected +
                                                     totals.refracted + totals.shadow);
}

RootStatistics roots_of(const OperationCounts& work) {
  RootStatistics roots;
  roots.found = work[static_cast<std::size_t>(firmware::Operation::root)];
  roots.steps = work[static_cast<std::size_t>(firmware::Operation::root_step)];
  roots.steps_per_root =
      roots.found == 0 ? 0 : static_cast<double>(roots.steps) / static_cast<double>(roots.found);
  return roots;
}

/// Busy is what is not idle.
double imbalance_of(const models::MachineStatistics& model) {
  models::Duration longest{};
  models::Wide sum_ps = 0;
  for (const models::BoardStatistics& board : model.boards) {
    longest = std::max(longest, model.frame_time - board.idle);
    sum_ps += (model.frame_time - board.idle).count();
  }
  return sum_ps == 0
             ? 0
             : static_cast<double>(longest.count()) * static_cast<double>(model.boards.size()) /
                       static_cast<double>(sum_ps) -
                   1;
}

FrameStatistics frame_of(const models::MachineStatistics& model, const Machine& machine) {
  FrameStatistics frame;
  frame.width = machine.parameters.frame_memory.width;
  frame.height = machine.parameters.frame_memory.height;
  frame.time = model.frame_time;
  frame.load = model.load_time;
  frame.pixels_total = std::int64_t{frame.width} * frame.height;
  for (const models::BoardStatistics& board : model.boards) {
    frame.preprocess = std::max(frame.preprocess, board.preprocessing);
    frame.pixels_synthesised += board.pixels;
  }
  frame.imbalance = imbalance_of(model);
  frame.preprocess = std::min(frame.preprocess, frame.time);
  frame.synthesis = frame.time - frame.preprocess;
  return frame;
}

}  // namespace

Statistics frame_statistics(const models::MachineStatistics& model, const Machine& machine,
                            const models::PixelRectangle& useful_zone,
                            const firmware::Work& preprocessing) {
  Statistics statistics;
  statistics.frame = frame_of(model, machine);
  statistics.useful_zone = {useful_zone.column0, useful_zone.row0, useful_zone.width,
                            useful_zone.height};
  for (std::size_t i = 0; i < model.boards.size(); ++i) {
    statistics.boards.push_back(board_statistics(model.boards[i], i, model.frame_time));
    add_totals(model.boards[i].work, statistics);
  }
  statistics.roots = roots_of(statistics.work);
  statistics.bus = contention_statistics(model, !machine.parameters.bus.level.is_exclusive);
  statistics.units = units_statistics(model, statistics.bus.utilisation);
  std::copy(std::begin(preprocessing.counts), std::end(preprocessing.counts),
            statistics.preprocess_work.begin());
  statistics.partial = !model.has_finished;
  statistics.end_reason = model.has_finished ? "all boards are done" : "interrupted";
  return statistics;
}

}  // namespace maquette::sim
