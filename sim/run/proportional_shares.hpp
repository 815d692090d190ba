#pragma once

#include <vector>

#include "models/bus/duration.hpp"
#include "models/bus/wide.hpp"

namespace maquette::sim {

/// Divides a time in proportion to weights, none of which is negative, to the last tick: each share
/// rounded down, the ticks that are left to the largest remainders, of equal ones to the first.
/// Without any weight all shares are zero.
std::vector<models::Duration> proportional_shares(models::Duration total,
                                                  std::vector<models::Wide> weights);

}  // namespace maquette::sim
