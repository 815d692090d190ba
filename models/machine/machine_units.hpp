#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <systemc>
#include <utility>
#include <vector>

#include "models/board/kvm02.hpp"
#include "models/bus/versabus.hpp"
#include "models/machine/machine_addresses.hpp"
#include "models/machine/machine_parameters.hpp"
#include "models/unit/errand_desk.hpp"
#include "models/unit/function_unit.hpp"
#include "models/unit/itinerary.hpp"
#include "models/unit/unit_group.hpp"
#include "models/unit/unit_statistics.hpp"

namespace maquette::models {

/// The function units of a machine and the desks of its boards.
class MachineUnits {
 public:
  /// Attaches the units to the bus, after its boards. All is kept by reference. Throws
  /// std::invalid_argument for units with which the machine could deadlock, or that are none.
  MachineUnits(const MachineParameters& parameters, const MachineAddresses& addresses,
               VersaBus& bus, LegSource& legs, const sc_core::sc_event& start);

  /// Has a board hand out errands; `mailbox` is the bus address in its RAM at which it takes what
  /// comes back. In the order of their numbers.
  void serve(Kvm02& board, std::uint64_t mailbox);

  /// Masters of the bus, one after the other.
  [[nodiscard]] const std::vector<int>& masters() const { return masters_; }

  /// The pauses of each unit are shown to what `observer` gives for its place among the masters.
  void observe_pauses(const std::function<PauseObserver(std::size_t)>& observer);

  /// What is handed over is shown to `observer`.
  void observe_handovers(HandoverObserver observer) { handovers_ = std::move(observer); }

  /// Up to here its states are known, perhaps ahead of the kernel.
  [[nodiscard]] Instant accounted() const;

  [[nodiscard]] std::vector<UnitKindStatistics> statistics(Instant instant) const;

 private:
  void make_units(std::size_t kind, const MachineAddresses& addresses,
                  const sc_core::sc_event& start);

  MachineParameters parameters_;
  VersaBus& bus_;
  LegSource& legs_;
  Itinerary itinerary_;
  HandoverObserver handovers_;
  UnitGroups groups_;
  std::vector<std::vector<std::unique_ptr<FunctionUnit>>> units_;  // by kind
  std::vector<int> masters_;
  std::vector<std::unique_ptr<ErrandDesk>> desks_;
};

}  // namespace maquette::models
