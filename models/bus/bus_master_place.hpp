#pragma once

namespace maquette::models {

/// Where a master sits on the bus.
struct BusMasterPlace {
  int level = 0;     ///< request level 0..4; 4 is the highest
  int position = 0;  ///< in the daisy chain of its level; 0 is nearest to the arbiter
};

}  // namespace maquette::models
