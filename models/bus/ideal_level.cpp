#include "models/bus/ideal_level.hpp"

#include "models/bus/arbitrated_engine.hpp"
#include "models/bus/ideal_arbiter.hpp"

namespace maquette::models {

std::unique_ptr<BusEngine> make_ideal_engine(const VersaBusParameters& /*parameters*/,
                                             const BusParts& parts) {
  return std::make_unique<ArbitratedEngine>("engine", std::make_unique<IdealArbiter>(), parts);
}

}  // namespace maquette::models
