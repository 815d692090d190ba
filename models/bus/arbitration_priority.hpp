#pragma once

#include "models/bus/arbitration.hpp"

namespace maquette::models {

/// Highest level first; within a level the one nearest to the arbiter in the daisy chain
/// (VM02 data sheet p. 2-54 and 2-58; order in the chain as on its successor VMEbus).
[[nodiscard]] int choose_by_priority(const Contenders& contenders, int previous);

inline constexpr ArbitrationPolicy k_priority{"priority", choose_by_priority, true,
                                              GrantChain::levels};

}  // namespace maquette::models
