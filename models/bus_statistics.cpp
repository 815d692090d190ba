#include "models/bus_statistics.hpp"

#include <algorithm>

namespace maquette::models {

BusMasterStatistics total(const BusStatistics& statistics) {
  BusMasterStatistics sum;
  for (const BusMasterStatistics& master : statistics.masters) {
    sum.transfers += master.transfers;
    sum.delayed += master.delayed;
    sum.errors += master.errors;
    sum.busy += master.busy;
    sum.held += master.held;
    sum.arbitration += master.arbitration;
    sum.waited += master.waited;
    if (master.longest_wait > sum.longest_wait) {
      sum.longest_wait = master.longest_wait;
      sum.longest_wait_request = master.longest_wait_request;
      sum.longest_wait_behind = master.longest_wait_behind;
    }
    sum.waits.add(master.waits);
  }
  return sum;
}

int longest_waiting_master(const BusStatistics& statistics) {
  const auto& masters = statistics.masters;
  const auto longest = std::max_element(
      masters.begin(), masters.end(),
      [](const auto& a, const auto& b) { return a.longest_wait < b.longest_wait; });
  return longest == masters.end() ? k_nobody : static_cast<int>(longest - masters.begin());
}

}  // namespace maquette::models
