#include "models/bus/decoupled_level.hpp"

#include "models/bus/arbitrated_engine.hpp"
#include "models/bus/queueing_arbiter.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

std::unique_ptr<BusEngine> make_decoupled_engine(const VersaBusParameters& parameters,
                                                 const BusParts& parts) {
  return std::make_unique<ArbitratedEngine>(
      "engine", std::make_unique<QueueingArbiter>(parameters, parameters.quantum, parts.account),
      parts);
}

}  // namespace maquette::models
