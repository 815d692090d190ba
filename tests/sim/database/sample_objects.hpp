#pragma once

#include <utility>
#include <vector>

#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// A combination of objects with the surface "matt".
inline Object combined(firmware::BooleanOperator combination, std::vector<Object> children) {
  Object object;
  object.combination = combination;
  object.surface = "matt";
  object.children = std::move(children);
  return object;
}

}  // namespace maquette::sim
