#pragma once

#include <string>

#include "sim/accuracy/ladder.hpp"
#include "sim/machine/machine.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A level with the description that its overrides make.
struct LevelTask {
  std::string name;  ///< for messages
  Level level;
  Scene scene;
  Machine machine;
};

}  // namespace maquette::sim
