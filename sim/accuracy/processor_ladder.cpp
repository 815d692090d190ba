#include <fmt/format.h>

#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

Ladder processor_ladder(int share) {
  const bool is_sampled = share > 1;
  std::string executed = "instruction";
  std::string varies =
      "how the boards' pixels and their time are computed (run --processor, board.costs)";
  if (is_sampled) {
    executed += fmt::format(" 1/{}", share);
    varies += fmt::format(
        "; one in {} pixels is executed, frame time and host time are "
        "extrapolated from it, and waiting is not known",
        share);
  }
  return {"processor",
          varies,
          ErrorMeasure::frame_time,
          {{executed, {}, LevelKind::executed, share},
           {"counted", {"board.costs=calibrated"}, LevelKind::simulation, share},
           {"counted by tables", {"board.costs=tables"}, LevelKind::simulation, share},
           {"recorded", {}, LevelKind::recorded}},
          0};
}

}  // namespace maquette::sim
