#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

std::vector<std::string> default_quanta() {
  return {"1 us", "10 us", "100 us", "1 ms", "10 ms", "100 ms"};
}

Ladder bus_ladder(const std::vector<std::string>& quanta) {
  Ladder ladder{"bus",
                "how exactly the bus is simulated (bus.level, bus.quantum)",
                ErrorMeasure::frame_time,
                {{"transaction", {"bus.level=transaction"}}},
                0};
  for (const std::string& quantum : quanta) {
    ladder.levels.push_back(
        {"decoupled " + quantum, {"bus.level=decoupled", "bus.quantum=" + quantum}});
  }
  ladder.levels.push_back({"ideal", {"bus.level=ideal"}});
  return ladder;
}

}  // namespace maquette::sim
