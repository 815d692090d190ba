#include "models/bus/ideal_level.hpp"

#include "models/bus/ideal_arbiter.hpp"

namespace maquette::models {

std::unique_ptr<BusArbiter> make_ideal_arbiter(const VersaBusParameters& /*parameters*/,
                                               BusAccount& /*account*/) {
  return std::make_unique<IdealArbiter>();
}

}  // namespace maquette::models
