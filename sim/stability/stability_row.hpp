#pragma once

#include <optional>
#include <string>

namespace maquette::sim {

/// A figure of the measured stability, and how large it may be.
struct StabilityRow {
  std::string group;    ///< what is measured: roots, scale, ...
  std::string subject;  ///< the family, scene, primitive or kind of input
  std::string counted;  ///< what the value counts or is
  double value = 0;
  std::optional<double> bound;  ///< the most that is allowed; nothing where the figure only informs

  /// A value that is not a number holds no bound.
  [[nodiscard]] bool holds() const { return !bound || value <= *bound; }
};

}  // namespace maquette::sim
