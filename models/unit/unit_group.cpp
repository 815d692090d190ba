#include "models/unit/unit_group.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "models/bus/kernel_time.hpp"
#include "models/unit/function_unit.hpp"

namespace maquette::models {

UnitGroup::UnitGroup(const sc_core::sc_module_name& name, const FunctionUnitParameters& parameters,
                     VersaBus& bus)
    : sc_module(name),
      parameters_(parameters),
      bus_(bus),
      bystander_(bus.attach_bystander()),
      decision_("decision") {
  if (parameters.queue < 1 || parameters.number < 1) {
    throw std::invalid_argument("function units must be there and have places");
  }
  SC_HAS_PROCESS(UnitGroup);
  SC_METHOD(decide);
  sensitive << decision_;
  dont_initialize();
}

void UnitGroup::ask(Errand& errand, const PlaceGrant& grant) {
  errand.since = kernel_now();
  const auto before = [](const Request& a, const Request& b) {
    return std::tie(a.errand->since, a.errand->board, a.errand->number) <
           std::tie(b.errand->since, b.errand->board, b.errand->number);
  };
  const Request request{&errand, &grant};
  requests_.insert(std::upper_bound(requests_.begin(), requests_.end(), request, before), request);
  ++asked_;
  decide_in_a_tick();
}

void UnitGroup::freed() {
  if (!requests_.empty()) {
    decide_in_a_tick();
  }
}

// Where a decision of this instant is still to come, the bus knows of that one.
void UnitGroup::decide_in_a_tick() {
  const bool decides_now = next_decision_ == kernel_now();
  next_decision_ = kernel_now() + k_tick;
  decision_.notify(to_sc_time(k_tick));
  if (!decides_now) {
    bus_.expect(bystander_, next_decision_);
  }
}

void UnitGroup::decide() {
  meet_requests();
  if (next_decision_ == kernel_now()) {
    next_decision_ = k_never;
  }
  bus_.expect(bystander_, next_decision_);
}

// Those that wait for a unit which is full are passed over by those for others. What is asked for
// or freed in this instant has its own decision, so that the kernel's order of processes is no
// matter.
void UnitGroup::meet_requests() {
  const auto met = [this](const Request& request) {
    const bool is_new = request.errand->since == kernel_now();
    FunctionUnit* unit = is_new ? nullptr : choose(*request.errand);
    if (unit == nullptr) {
      return false;
    }
    unit->reserve();
    request.errand->place = unit;
    waited_.add(kernel_now() - request.errand->since);
    (*request.grant)(*request.errand);
    return true;
  };
  requests_.erase(std::remove_if(requests_.begin(), requests_.end(), met), requests_.end());
}

FunctionUnit* UnitGroup::choose(const Errand& errand) const {
  const auto has_room = [this](const FunctionUnit* unit) {
    return unit->places_taken() < parameters_.queue;
  };
  if (parameters_.choice == UnitChoice::by_pixel) {
    const auto place = static_cast<std::size_t>(errand.pixel.column) + errand.pixel.row;
    FunctionUnit* unit = units_[place % units_.size()];
    return has_room(unit) ? unit : nullptr;
  }
  FunctionUnit* least = *std::min_element(
      units_.begin(), units_.end(),
      [](const FunctionUnit* a, const FunctionUnit* b) { return a->load() < b->load(); });
  return has_room(least) ? least : nullptr;
}

}  // namespace maquette::models
