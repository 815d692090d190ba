#pragma once

#include <string>
#include <vector>

#include "sim/run/scene_warnings.hpp"
#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// Prints warnings to standard error, each with its place in the scene's file, and keeps them for
/// the manifest.
class Warnings {
 public:
  /// The description is kept by reference.
  explicit Warnings(const Description& description) : description_(description) {}

  void tell(const SceneWarning& warning);
  [[nodiscard]] const std::vector<std::string>& told() const { return told_; }

 private:
  const Description& description_;
  std::vector<std::string> told_;
};

}  // namespace maquette::sim
