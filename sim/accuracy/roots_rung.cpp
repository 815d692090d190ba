#include <fmt/format.h>

#include "sim/accuracy/rungs.hpp"

namespace maquette::sim {

Rung roots_rung() {
  Rung rung{"roots",
            "tolerance of the roots that give a ray's hits, in spacings (roots.tolerance)",
            ErrorMeasure::picture,
            {},
            0};
  for (const int spacings : {1, 16, 256, 4096, 65'536, 1'000'000}) {
    rung.levels.push_back({fmt::format("{} spacings", spacings),
                           {fmt::format("roots.tolerance={}", spacings)},
                           LevelKind::simulation});
  }
  rung.levels.front().name = "1 spacing";
  return rung;
}

}  // namespace maquette::sim
