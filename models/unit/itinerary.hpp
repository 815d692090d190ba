#pragma once

#include <array>
#include <optional>
#include <vector>

#include "models/board/work_cost.hpp"
#include "models/unit/errand.hpp"
#include "models/unit/pixel_leg.hpp"
#include "models/unit/unit_parameters.hpp"

namespace maquette::models {

/// Where the legs of pixels are done in a machine, and how long they take there.
///
/// A leg is of the first kind of units, in the order of UnitKind from its end, that there are and
/// that serve it: whole secondary rays before single stages. Neighbouring legs of one kind, or of
/// the board, are one hop, which is handed what the first of them is and hands back what the last
/// of them does.
class Itinerary {
 public:
  /// Throws as WorkCost.
  Itinerary(const Kvm02Parameters& board, const UnitsParameters& units);

  /// Writes the hops of a pixel's legs in place of `hops`.
  void make(const std::vector<PixelLeg>& legs, std::vector<Hop>& hops) const;

 private:
  [[nodiscard]] int kind_of(const PixelLeg& leg) const;
  [[nodiscard]] Duration time_of(int kind, const firmware::Work& work) const;

  WorkCost board_;
  std::array<std::optional<WorkCost>, k_unit_kind_count> units_;  // of the kinds that there are
};

}  // namespace maquette::models
