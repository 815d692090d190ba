#include "models/bus/decoupled_level.hpp"

#include "models/bus/queueing_arbiter.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

std::unique_ptr<BusArbiter> make_decoupled_arbiter(const VersaBusParameters& parameters,
                                                   BusAccount& account) {
  return std::make_unique<QueueingArbiter>(parameters, parameters.quantum, account);
}

}  // namespace maquette::models
