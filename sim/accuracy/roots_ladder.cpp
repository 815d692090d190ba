#include <fmt/format.h>

#include "sim/accuracy/ladders.hpp"

namespace maquette::sim {

Ladder roots_ladder() {
  Ladder ladder{"roots",
                "tolerance of the roots that give a ray's hits, in ulps (roots.tolerance)",
                ErrorMeasure::picture,
                {},
                0};
  for (const int ulps : {1, 16, 256, 4096, 65'536, 1'000'000}) {
    ladder.levels.push_back({fmt::format("{} ulps", ulps),
                             {fmt::format("roots.tolerance={}", ulps)},
                             LevelKind::simulation});
  }
  ladder.levels.front().name = "1 ulp";
  return ladder;
}

}  // namespace maquette::sim
