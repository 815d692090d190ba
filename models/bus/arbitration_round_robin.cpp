#include "models/bus/arbitration_round_robin.hpp"

#include <algorithm>

namespace maquette::models {

int choose_in_turn(const Contenders& contenders, int previous) {
  const auto comes_before = [previous](const Contender& a, const Contender& b) {
    const bool a_wraps = a.master <= previous;
    const bool b_wraps = b.master <= previous;
    return a_wraps != b_wraps ? b_wraps : a.master < b.master;
  };
  return std::min_element(contenders.begin(), contenders.end(), comes_before)->master;
}

}  // namespace maquette::models
