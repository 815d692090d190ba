#include "models/unit/itinerary.hpp"

#include <algorithm>
#include <functional>
#include <iterator>

namespace maquette::models {

namespace {

Kvm02Parameters with(const Kvm02Parameters& board, const FunctionUnitParameters& unit) {
  Kvm02Parameters costs = board;
  costs.clock_hz = unit.clock_hz.value_or(board.clock_hz);
  if (unit.costs) {
    costs.arithmetic = *unit.costs;
  }
  return costs;
}

}  // namespace

Itinerary::Itinerary(const Kvm02Parameters& board, const UnitsParameters& units) : board_(board) {
  for (std::size_t kind = 0; kind < units_.size(); ++kind) {
    if (units.kinds[kind].number > 0) {
      units_[kind].emplace(with(board, units.kinds[kind]));
    }
  }
}

int Itinerary::kind_of(const PixelLeg& leg) const {
  for (int kind = k_unit_kind_count - 1; kind >= 0; --kind) {
    if (units_[static_cast<std::size_t>(kind)] && serves(static_cast<UnitKind>(kind), leg)) {
      return kind;
    }
  }
  return Hop::k_at_board;
}

Duration Itinerary::time_of(int kind, const firmware::Work& work) const {
  return kind == Hop::k_at_board ? board_.duration(work)
                                 : units_[static_cast<std::size_t>(kind)]->duration(work);
}

// A hop is priced once, as what a board does of a whole pixel is.
void Itinerary::make(const std::vector<PixelLeg>& legs, std::vector<Hop>& hops) const {
  hops.clear();
  firmware::Work work{};
  for (const PixelLeg& leg : legs) {
    const int kind = kind_of(leg);
    if (hops.empty() || hops.back().kind != kind) {
      if (!hops.empty()) {
        hops.back().time = time_of(hops.back().kind, work);
      }
      hops.push_back({kind, leg.numbers_in, leg.numbers_out, Duration::zero()});
      work = leg.work;
    } else {
      hops.back().numbers_out = leg.numbers_out;
      std::transform(std::begin(work.counts), std::end(work.counts), std::begin(leg.work.counts),
                     std::begin(work.counts), std::plus<>());
    }
  }
  if (!hops.empty()) {
    hops.back().time = time_of(hops.back().kind, work);
  }
}

}  // namespace maquette::models
