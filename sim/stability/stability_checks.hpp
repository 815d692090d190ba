#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/stability/sample_solids.hpp"
#include "sim/stability/shipped_scenes.hpp"
#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// What the stability is measured on.
struct StabilityMaterial {
  std::string exact_roots_file;
  std::vector<ShippedScene> scenes;
  std::vector<SolidFamily> families;
};

/// Reads the scenes of a directory. Throws DescriptionError.
[[nodiscard]] StabilityMaterial stability_material(const std::string& scenes_directory,
                                                   const std::string& exact_roots_file);

/// A piece of a group's measurement, with the rows it gives.
struct StabilityCheck {
  std::string group;
  std::function<std::vector<StabilityRow>()> measure;
};

/// The groups of checks, in their order.
[[nodiscard]] const std::vector<std::string>& stability_groups();

/// All checks of one number type, each primitive and each scene of the material one by one; those
/// of machines, which have none, are among those of float. `share` of the full number of random
/// cases and pixels is tried, above 0 and 1 for all. The material must outlive the checks.
template <class Real>
[[nodiscard]] std::vector<StabilityCheck> stability_checks(const StabilityMaterial& material,
                                                           double share);

}  // namespace maquette::sim
