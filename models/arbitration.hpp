#pragma once

#include <vector>

#include "models/machine_parameters.hpp"

namespace maquette::models {

/// No master of a bus.
inline constexpr int k_nobody = -1;

/// A master that requests the bus at the instant of an arbitration.
struct Contender {
  int master;  ///< its number on the bus
  BusMasterPlace place;
};

/// Highest level first; within a level the one nearest to the arbiter in the daisy chain
/// (VM02 data sheet p. 2-54 and 2-58; order in the chain as on its successor VMEbus). Returns the
/// number of the master that gets the bus; `contenders` is not empty.
int choose_by_priority(const std::vector<Contender>& contenders);

/// The first contender after `previous` in the ring of master numbers, whatever its level; with no
/// previous master the lowest number. `contenders` is not empty and in ascending order.
int choose_in_turn(const std::vector<Contender>& contenders, int previous);

/// What the policy chooses. `previous` is the last master that had the bus, or k_nobody.
int choose(ArbitrationPolicy policy, const std::vector<Contender>& contenders, int previous);

}  // namespace maquette::models
