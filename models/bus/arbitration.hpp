#pragma once

#include <string_view>

#include "models/bus/bus_master_place.hpp"
#include "models/bus/instant.hpp"

namespace maquette::models {

/// No master of a bus.
inline constexpr int k_nobody = -1;

/// A master that requests the bus.
struct Contender {
  int master;  ///< its number on the bus
  BusMasterPlace place;
  Instant request;  ///< since when
};

/// The masters of one arbitration, in any order; never none.
struct Contenders {
  const Contender* first;
  const Contender* last;

  [[nodiscard]] const Contender* begin() const { return first; }
  [[nodiscard]] const Contender* end() const { return last; }
};

/// Along which of its lines the backplane's grant goes from board to board, each of which passes it
/// on unless it wants the bus. That is a policy in hardware: it chooses as `choose` does.
enum class GrantChain {
  levels,  ///< one chain per request level, by position; the highest level that requests is granted
  ring     ///< one ring of all masters by number, from the one after the last that had the bus
};

/// Which master the arbiter of the bus prefers among those of the same instant. A policy is a
/// constant in a file of its own and a row of arbitration_policies.hpp.
struct ArbitrationPolicy {
  std::string_view name;  ///< in descriptions

  /// The number of the master that gets the bus. `previous` is the last one that had it, or
  /// k_nobody.
  int (*choose)(const Contenders& contenders, int previous);

  bool clears_bus;  ///< a request of a strictly higher level ends another's block (BCLR)
  GrantChain chain;
};

constexpr bool operator==(const ArbitrationPolicy& a, const ArbitrationPolicy& b) {
  return a.name == b.name;
}

}  // namespace maquette::models
