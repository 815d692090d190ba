#pragma once

#include <functional>
#include <systemc>
#include <vector>

#include "models/bus/instant.hpp"
#include "models/bus/versabus.hpp"
#include "models/unit/errand.hpp"
#include "models/unit/unit_parameters.hpp"
#include "models/unit/unit_statistics.hpp"

namespace maquette::models {

/// Tells whoever has asked for a place for an errand that errand.place keeps it.
using PlaceGrant = std::function<void(Errand& errand)>;

/// The units of one kind, and who has a place in their queues. Nobody sends an errand before it has
/// a place, so that every message is taken at once and no queue overflows.
///
/// Places are given in the order in which they are asked for, to boards of lower numbers first in
/// one instant, by a line beside the bus that takes the tick after. Assumption: that line costs
/// nothing else.
class UnitGroup : public sc_core::sc_module {
 public:
  /// The bus, whose masters it has go on, is kept by reference.
  UnitGroup(const sc_core::sc_module_name& name, const FunctionUnitParameters& parameters,
            VersaBus& bus);

  /// Its next unit, kept by reference.
  void add(FunctionUnit& unit) { units_.push_back(&unit); }

  /// Asks for a place for an errand; `grant`, which is kept by reference, is called a tick later at
  /// the earliest.
  void ask(Errand& errand, const PlaceGrant& grant);

  /// One of its units has a place more.
  void freed();

  [[nodiscard]] std::int64_t places() const { return asked_; }
  [[nodiscard]] const ErrandWait& waited() const { return waited_; }

 private:
  struct Request {
    Errand* errand;
    const PlaceGrant* grant;
  };

  void decide_in_a_tick();
  void decide();
  void meet_requests();
  [[nodiscard]] FunctionUnit* choose(const Errand& errand) const;

  FunctionUnitParameters parameters_;
  VersaBus& bus_;
  int bystander_;  // of the bus
  std::vector<FunctionUnit*> units_;
  std::vector<Request> requests_;  // in the order in which they are met
  sc_core::sc_event decision_;
  Instant next_decision_ = k_never;
  std::int64_t asked_ = 0;
  ErrandWait waited_;
};

}  // namespace maquette::models
