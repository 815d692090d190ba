#pragma once

#include <string>
#include <vector>

#include "sim/scene/scene.hpp"
#include "tools/benchmark/rows.hpp"

namespace maquette::benchmark {

/// A scene that the plain firmware and POV-Ray both render.
struct PeerScene {
  const char* name;
  const char* file;  ///< of peer/, without its extension
  void (*complete)(sim::Scene& scene);
  double bound;  ///< of the time, over POV-Ray's
  const char* meaning;
};

/// All that are compared.
[[nodiscard]] const std::vector<PeerScene>& peer_scenes();

}  // namespace maquette::benchmark
