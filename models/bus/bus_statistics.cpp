#include "models/bus/bus_statistics.hpp"

#include <algorithm>

#include "models/bus/checked_sum.hpp"

namespace maquette::models {

namespace {

void add(BusMasterStatistics& sum, const BusMasterStatistics& master) {
  sum.transfers += master.transfers;
  sum.delayed += master.delayed;
  sum.errors += master.errors;
  sum.busy = checked_sum(sum.busy, master.busy);
  sum.held = checked_sum(sum.held, master.held);
  sum.arbitration = checked_sum(sum.arbitration, master.arbitration);
  sum.handover = checked_sum(sum.handover, master.handover);
  sum.waited = checked_sum(sum.waited, master.waited);
  if (master.longest_wait > sum.longest_wait) {
    sum.longest_wait = master.longest_wait;
    sum.longest_wait_request = master.longest_wait_request;
    sum.longest_wait_behind = master.longest_wait_behind;
  }
  sum.waits.add(master.waits);
}

}  // namespace

BusMasterStatistics total(const BusStatistics& statistics) {
  BusMasterStatistics sum;
  for (const BusMasterStatistics& master : statistics.masters) {
    add(sum, master);
  }
  return sum;
}

BusStatistics combined(const std::vector<BusStatistics>& backplanes, std::size_t boards) {
  BusStatistics all;
  all.masters.resize(boards + 1);
  all.waited_for.assign(boards + 1, std::vector<Duration>(boards + 1));
  all.queue_times.resize(boards + 1);
  for (std::size_t i = 0; i < backplanes.size(); ++i) {
    const BusStatistics& one = backplanes[i];
    const auto number = [&](std::size_t master) {
      return master + 1 == one.masters.size() ? boards : i + master * backplanes.size();
    };
    for (std::size_t a = 0; a < one.masters.size(); ++a) {
      BusMasterStatistics master = one.masters[a];
      if (master.longest_wait_behind != k_nobody) {
        master.longest_wait_behind =
            static_cast<int>(number(static_cast<std::size_t>(master.longest_wait_behind)));
      }
      add(all.masters[number(a)], master);
      for (std::size_t b = 0; b < one.masters.size(); ++b) {
        all.waited_for[number(a)][number(b)] += one.waited_for[a][b];
      }
      all.queue_times[a] = checked_sum(all.queue_times[a], one.queue_times[a]);
    }
  }
  return all;
}

int longest_waiting_master(const BusStatistics& statistics) {
  const auto& masters = statistics.masters;
  const auto longest = std::max_element(
      masters.begin(), masters.end(),
      [](const auto& a, const auto& b) { return a.longest_wait < b.longest_wait; });
  return longest == masters.end() ? k_nobody : static_cast<int>(longest - masters.begin());
}

}  // namespace maquette::models
