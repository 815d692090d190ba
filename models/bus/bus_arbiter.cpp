#include "models/bus/bus_arbiter.hpp"

#include <stdexcept>

#include "models/bus/ideal_arbiter.hpp"
#include "models/bus/queueing_arbiter.hpp"

namespace maquette::models {

std::unique_ptr<BusArbiter> make_arbiter(const VersaBusParameters& parameters,
                                         BusAccount& account) {
  if (parameters.quantum < Duration::zero()) {
    throw std::invalid_argument("the quantum of a bus must not be negative");
  }
  switch (parameters.level) {
    case BusLevel::ideal:
      return std::make_unique<IdealArbiter>();
    case BusLevel::decoupled:
      return std::make_unique<QueueingArbiter>(parameters, parameters.quantum, account);
    case BusLevel::transaction:
      break;
  }
  return std::make_unique<QueueingArbiter>(parameters, Duration::zero(), account);
}

}  // namespace maquette::models
