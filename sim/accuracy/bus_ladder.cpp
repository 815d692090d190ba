#include <fmt/format.h>
#include <string>

#include "models/bus/bus_levels.hpp"
#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

std::vector<std::string> default_quanta() {
  return {"1 us", "10 us", "100 us", "1 ms", "10 ms", "100 ms"};
}

Ladder bus_ladder(const std::vector<std::string>& quanta) {
  Ladder ladder{"bus",
                "how exactly the bus is simulated (bus.level, bus.quantum)",
                ErrorMeasure::frame_time,
                {},
                0};
  for (const models::BusLevel& level : models::k_bus_levels) {
    const std::string name(level.name);
    if (!level.has_quantum) {
      ladder.levels.push_back({name, {"bus.level=" + name}});
      continue;
    }
    for (const std::string& quantum : quanta) {
      ladder.levels.push_back(
          {fmt::format("{} {}", name, quantum), {"bus.level=" + name, "bus.quantum=" + quantum}});
    }
  }
  return ladder;
}

}  // namespace maquette::sim
