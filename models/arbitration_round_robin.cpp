#include <algorithm>

#include "models/arbitration.hpp"

namespace maquette::models {

int choose_in_turn(const std::vector<Contender>& contenders, int previous) {
  const auto next =
      std::find_if(contenders.begin(), contenders.end(),
                   [previous](const Contender& contender) { return contender.master > previous; });
  return next == contenders.end() ? contenders.front().master : next->master;
}

}  // namespace maquette::models
