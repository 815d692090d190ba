#include <fmt/format.h>

#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

Ladder processor_ladder(int tile_share) {
  const bool is_sampled = tile_share > 1;
  std::string executed = "instruction";
  std::string varies = "how the boards' pixels and their time are computed (run --processor)";
  if (is_sampled) {
    executed += fmt::format(", 1 in {}", tile_share);
    varies += fmt::format(
        "; of the instructions those of one in {} tiles are executed, frame time and host time are "
        "extrapolated from these, and waiting is not known",
        tile_share);
  }
  return {"processor",
          varies,
          ErrorMeasure::frame_time,
          {{executed, {}, LevelKind::executed, tile_share},
           {"counted", {}, LevelKind::simulation, tile_share},
           {"recorded", {}, LevelKind::recorded, tile_share}},
          0};
}

}  // namespace maquette::sim
