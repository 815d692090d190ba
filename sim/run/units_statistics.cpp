#include "sim/run/units_statistics.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "models/bus/checked_sum.hpp"

namespace maquette::sim {

namespace {

using models::Duration;

double share(Duration part, Duration whole) {
  return whole.count() > 0 ? static_cast<double>(part.count()) / static_cast<double>(whole.count())
                           : 0;
}

/// To the nearest tick.
Duration mean(Duration sum, std::int64_t count) {
  return count > 0 ? Duration((sum.count() + count / 2) / count) : Duration::zero();
}

FunctionUnitStatistics unit_statistics(const models::FunctionUnitStatistics& unit, std::string name,
                                       Duration frame_time) {
  const models::BoardStatistics& states = unit.states;
  if (states.compute + states.wait_grant + states.transfer + states.wait_unit + states.idle !=
      frame_time) {
    throw std::logic_error(name + "'s states do not sum to the frame time");
  }
  FunctionUnitStatistics result;
  result.name = std::move(name);
  result.errands = unit.errands;
  result.serve = states.compute;
  result.wait_grant = states.wait_grant;
  result.transfer = states.transfer;
  result.wait_place = states.wait_unit;
  result.idle = states.idle;
  result.utilisation = share(frame_time - states.idle, frame_time);
  result.queue_mean = share(unit.queued.sum, frame_time);
  result.queue_longest = unit.longest_queue;
  result.queued_max = unit.queued.longest;
  return result;
}

UnitKindStatistics kind_statistics(const models::UnitKindStatistics& kind, Duration frame_time) {
  UnitKindStatistics result;
  result.kind = models::k_unit_kind_names[static_cast<std::size_t>(kind.kind)];
  Duration queued{};
  std::int64_t errands = 0;
  for (const models::FunctionUnitStatistics& unit : kind.units) {
    result.utilisation +=
        share(frame_time - unit.states.idle, frame_time) / static_cast<double>(kind.units.size());
    queued = models::checked_sum(queued, unit.queued.sum);
    errands += unit.errands;
  }
  result.place_mean = mean(kind.waited.sum, kind.places);
  result.place_max = kind.waited.longest;
  result.queued_mean = mean(queued, errands);
  return result;
}

BoardWaits board_waits(const models::MachineStatistics& model, std::size_t board) {
  BoardWaits waits;
  waits.name = fmt::format("board{}", board);
  waits.wait = model.boards[board].wait_unit;
  for (const models::UnitKindStatistics& kind : model.units) {
    waits.waited_for.push_back(kind.board_waits[board]);
  }
  return waits;
}

void find_bottleneck(double bus_utilisation, UnitsStatistics& units) {
  const auto meet = [&units](const std::string& name, double utilisation) {
    if (utilisation > units.bottleneck_utilisation) {
      units.bottleneck = name;
      units.bottleneck_utilisation = utilisation;
    }
  };
  meet("boards", units.board_utilisation);
  for (const UnitKindStatistics& kind : units.kinds) {
    meet(kind.kind, kind.utilisation);
  }
  meet("bus", bus_utilisation);
}

}  // namespace

std::optional<UnitsStatistics> units_statistics(const models::MachineStatistics& model,
                                                double bus_utilisation) {
  if (model.units.empty()) {
    return std::nullopt;
  }
  UnitsStatistics result;
  for (std::size_t board = 0; board < model.boards.size(); ++board) {
    const models::BoardStatistics& states = model.boards[board];
    result.board_utilisation +=
        share(model.frame_time - states.idle - states.wait_unit, model.frame_time) /
        static_cast<double>(model.boards.size());
    result.boards.push_back(board_waits(model, board));
  }
  for (const models::UnitKindStatistics& kind : model.units) {
    result.kinds.push_back(kind_statistics(kind, model.frame_time));
    for (std::size_t i = 0; i < kind.units.size(); ++i) {
      result.units.push_back(unit_statistics(
          kind.units[i], fmt::format("{}{}", result.kinds.back().kind, i), model.frame_time));
    }
  }
  find_bottleneck(bus_utilisation, result);
  return result;
}

}  // namespace maquette::sim
