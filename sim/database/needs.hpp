#pragma once

#include <string>
#include <vector>

#include "firmware/database.hpp"
#include "sim/database/object_tree.hpp"
#include "sim/scene/scene.hpp"

namespace maquette::sim {

/// What of the firmware a scene needs; `surfaces` are those that its primitives have.
firmware::Needs needs_of(const Scene& scene, const ObjectTree& tree,
                         const std::vector<firmware::Surface<double>>& surfaces);

/// A need by name, for reports.
struct NamedNeed {
  std::string name;
  bool is_needed;
  firmware::Needs with;  ///< all needs of the scene, and this one
};

/// All needs in the order of the firmware's declaration.
std::vector<NamedNeed> named_needs(const firmware::Needs& needs);

}  // namespace maquette::sim
