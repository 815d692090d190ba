#include "models/bus/transaction_level.hpp"

#include "models/bus/queueing_arbiter.hpp"
#include "models/bus/versabus_parameters.hpp"

namespace maquette::models {

std::unique_ptr<BusArbiter> make_transaction_arbiter(const VersaBusParameters& parameters,
                                                     BusAccount& account) {
  return std::make_unique<QueueingArbiter>(parameters, Duration::zero(), account);
}

}  // namespace maquette::models
