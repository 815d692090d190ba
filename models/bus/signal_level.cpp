#include "models/bus/signal_level.hpp"

#include "models/bus/signal/signal_engine.hpp"

namespace maquette::models {

std::unique_ptr<BusEngine> make_signal_engine(const VersaBusParameters& parameters,
                                              const BusParts& parts) {
  return std::make_unique<SignalEngine>("engine", parameters, parts);
}

}  // namespace maquette::models
