#pragma once

#include "models/bus/arbitration.hpp"

namespace maquette::models {

/// The first contender after `previous` in the ring of master numbers, whatever its level; with no
/// previous master the lowest number.
[[nodiscard]] int choose_in_turn(const Contenders& contenders, int previous);

inline constexpr ArbitrationPolicy k_round_robin{"round_robin", choose_in_turn, false,
                                                 GrantChain::ring};

}  // namespace maquette::models
