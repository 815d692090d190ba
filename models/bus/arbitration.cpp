#include "models/bus/arbitration.hpp"

namespace maquette::models {

int choose(ArbitrationPolicy policy, const Contenders& contenders, int previous) {
  return policy == ArbitrationPolicy::priority ? choose_by_priority(contenders)
                                               : choose_in_turn(contenders, previous);
}

}  // namespace maquette::models
