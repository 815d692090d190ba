#include "models/bus/arbitration_priority.hpp"

#include <algorithm>

namespace maquette::models {

namespace {

bool comes_before(const Contender& a, const Contender& b) {
  if (a.place.level != b.place.level) {
    return a.place.level > b.place.level;
  }
  return a.place.position < b.place.position;
}

}  // namespace

int choose_by_priority(const Contenders& contenders, int /*previous*/) {
  return std::min_element(contenders.begin(), contenders.end(), comes_before)->master;
}

}  // namespace maquette::models
