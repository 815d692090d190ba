#include "sim/page/wait_matrix.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "sim/page/figures.hpp"
#include "sim/page/page_table.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_most_masters = 16;
constexpr std::size_t k_most_pairs = 100;

std::string name_of(const BusStatistics& bus, std::size_t waiting, std::size_t other) {
  return waiting == other ? "itself (arbitration)" : bus.masters[other].name;
}

Html pairs_of(const BusStatistics& bus) {
  struct Pair {
    std::size_t waiting, other;
    models::Duration time;
  };
  std::vector<Pair> pairs;
  for (std::size_t waiting = 0; waiting < bus.masters.size(); ++waiting) {
    const auto& times = bus.masters[waiting].waited_for;
    for (std::size_t other = 0; other < times.size() && other < bus.masters.size(); ++other) {
      pairs.push_back({waiting, other, times[other]});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const Pair& first, const Pair& second) { return first.time > second.time; });
  pairs.resize(std::min(pairs.size(), k_most_pairs));
  PageTable table{
      "Who waited longest for whom, of " + std::to_string(bus.masters.size()) + " masters",
      {{"master"}, {"waited for"}, {"time s", true}},
      {}};
  table.is_long = true;
  for (const Pair& pair : pairs) {
    table.rows.push_back({bus.masters[pair.waiting].name, name_of(bus, pair.waiting, pair.other),
                          format_seconds(pair.time)});
  }
  return table_element(table);
}

models::Duration longest_of(const BusStatistics& bus) {
  models::Duration longest{};
  for (const MasterStatistics& master : bus.masters) {
    for (const models::Duration time : master.waited_for) {
      longest = std::max(longest, time);
    }
  }
  return longest;
}

}  // namespace

Html wait_matrix(const BusStatistics& bus) {
  if (bus.masters.size() > k_most_masters) {
    return pairs_of(bus);
  }
  PageTable table{
      "Who waited for whom: time s of the master on the left while the one above had "
      "the bus; for itself: arbitration",
      {{"waits"}},
      {}};
  const double longest = in_seconds(longest_of(bus));
  for (const MasterStatistics& master : bus.masters) {
    table.columns.push_back({"for " + master.name, true});
    table.rows.push_back({master.name});
    table.shades.emplace_back();
    for (const models::Duration time : master.waited_for) {
      table.rows.back().push_back(format_seconds(time));
      table.shades.back().push_back(share_of(in_seconds(time), longest));
    }
  }
  return bus.masters.empty() ? Html{} : table_element(table);
}

}  // namespace maquette::sim
