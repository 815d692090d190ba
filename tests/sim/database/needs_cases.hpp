#pragma once

#include <vector>

#include "sim/database/needs.hpp"

/// Needs of scenes, for tests.
namespace maquette::tests {

/// Of a scene that needs everything.
inline firmware::Needs all_needs() {
  firmware::Needs needs{};
  const std::size_t count = sim::named_needs(needs).size();
  for (std::size_t i = 0; i < count; ++i) {
    needs = sim::named_needs(needs)[i].with;
  }
  return needs;
}

}  // namespace maquette::tests
