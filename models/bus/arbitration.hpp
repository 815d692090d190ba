#pragma once

#include "models/bus/instant.hpp"
#include "models/bus/versabus_parameters.hpp"

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

/// Highest level first; within a level the one nearest to the arbiter in the daisy chain
/// (VM02 data sheet p. 2-54 and 2-58; order in the chain as on its successor VMEbus). Returns the
/// number of the master that gets the bus.
int choose_by_priority(const Contenders& contenders);

/// The first contender after `previous` in the ring of master numbers, whatever its level; with no
/// previous master the lowest number.
int choose_in_turn(const Contenders& contenders, int previous);

/// What the policy chooses. `previous` is the last master that had the bus, or k_nobody.
int choose(ArbitrationPolicy policy, const Contenders& contenders, int previous);

}  // namespace maquette::models
