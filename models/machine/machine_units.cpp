#include "models/machine/machine_units.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace maquette::models {

namespace {

void check(const MachineParameters& parameters) {
  const auto in_flight = static_cast<std::int64_t>(parameters.boards.size()) *
                         static_cast<std::int64_t>(parameters.units.in_flight);
  if (in_flight > most_pixels_in_flight(parameters.units)) {
    throw std::invalid_argument("with so many pixels in flight function units could deadlock");
  }
  if (parameters.frame_memory.ports > 1 || is_shared(parameters.board.database) ||
      keeps_line(parameters.board.pixel_write)) {
    throw std::invalid_argument(
        "boards with function units have copies of the database and write pixels one by one, over "
        "one backplane");
  }
}

}  // namespace

MachineUnits::MachineUnits(const MachineParameters& parameters, const MachineAddresses& addresses,
                           VersaBus& bus, LegSource& legs, const sc_core::sc_event& start)
    : parameters_(parameters),
      bus_(bus),
      legs_(legs),
      itinerary_(parameters.board, parameters.units),
      units_(k_unit_kind_count) {
  check(parameters);
  for (std::size_t kind = 0; kind < k_unit_kind_count; ++kind) {
    if (parameters.units.kinds[kind].number > 0) {
      make_units(kind, addresses, start);
    }
  }
}

void MachineUnits::make_units(std::size_t kind, const MachineAddresses& addresses,
                              const sc_core::sc_event& start) {
  const FunctionUnitParameters& parameters = parameters_.units.kinds[kind];
  const std::string kind_name = k_unit_kind_names[kind];
  groups_[kind] = std::make_unique<UnitGroup>((kind_name + "_units").c_str(), parameters, bus_);
  for (int i = 0; i < parameters.number; ++i) {
    const std::size_t number = masters_.size();
    const std::uint64_t base = addresses.unit(number);
    units_[kind].push_back(std::make_unique<FunctionUnit>(
        (kind_name + std::to_string(i)).c_str(), parameters, parameters_.board,
        FunctionUnit::Site{bus_, base, *groups_[kind], groups_, start,
                           static_cast<int>(parameters_.boards.size() + number), handovers_}));
    FunctionUnit& unit = *units_[kind].back();
    groups_[kind]->add(unit);
    masters_.push_back(bus_.attach_master(
        unit.bus_master, {unit.name(), unit_place(parameters, parameters_.boards.size(), number),
                          unit.access_law()}));
    unit.set_master(masters_.back());
    bus_.attach_slave(unit.bus_port,
                      {unit.name(), base, FunctionUnit::address_bytes(parameters), true});
  }
}

void MachineUnits::serve(Kvm02& board, std::uint64_t mailbox) {
  desks_.push_back(std::make_unique<ErrandDesk>(
      static_cast<int>(desks_.size()), parameters_.board, parameters_.units.in_flight,
      ErrandDesk::Site{bus_, mailbox, groups_, itinerary_, legs_, handovers_}));
  board.dispatch([&desk = *desks_.back()](const DispatchedBoard& lent) { desk.run(lent); });
}

void MachineUnits::observe_pauses(const std::function<PauseObserver(std::size_t)>& observer) {
  std::size_t place = 0;
  for (const auto& kind : units_) {
    for (const auto& unit : kind) {
      unit->observe_pauses(observer(place++));
    }
  }
}

Instant MachineUnits::accounted() const {
  Instant furthest{};
  for (const auto& kind : units_) {
    for (const auto& unit : kind) {
      furthest = std::max(furthest, unit->accounted());
    }
  }
  return furthest;
}

std::vector<UnitKindStatistics> MachineUnits::statistics(Instant instant) const {
  std::vector<UnitKindStatistics> statistics;
  for (std::size_t kind = 0; kind < k_unit_kind_count; ++kind) {
    if (groups_[kind] == nullptr) {
      continue;
    }
    UnitKindStatistics& one = statistics.emplace_back();
    one.kind = static_cast<UnitKind>(kind);
    one.places = groups_[kind]->places();
    one.waited = groups_[kind]->waited();
    for (const auto& unit : units_[kind]) {
      one.units.push_back(unit->statistics(instant));
    }
    for (const auto& desk : desks_) {
      one.board_waits.push_back(desk->waits()[kind]);
    }
  }
  return statistics;
}

}  // namespace maquette::models
