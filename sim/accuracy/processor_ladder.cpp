#include <fmt/format.h>

#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

Ladder processor_ladder(int share, models::ArithmeticExecution execution) {
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
  Ladder ladder{k_processor_ladder,
                varies,
                ErrorMeasure::frame_time,
                {{executed, {}, LevelKind::executed, share}},
                0};
  if (execution == models::ArithmeticExecution::package) {
    ladder.levels.push_back({"arithmetic by the host",
                             {"board.arithmetic.execution=exact"},
                             LevelKind::executed,
                             share});
  }
  ladder.levels.push_back({"counted", {"board.costs=calibrated"}, LevelKind::simulation, share});
  ladder.levels.push_back(
      {"counted by tables", {"board.costs=tables"}, LevelKind::simulation, share});
  ladder.levels.push_back({"recorded", {}, LevelKind::recorded});
  return ladder;
}

}  // namespace maquette::sim
