#include <random>
#include <regex>
#include <sstream>

#include "sim/report/flat_json.hpp"
#include "sim/report/statistics_description.hpp"
#include "sim/report/statistics_json.hpp"
#include "tests/catch.hpp"
#include "tests/sim/report/random_statistics.hpp"

TEST_CASE("every key of stats.json is described") {
  const std::string description = maquette::sim::describe_statistics();
  maquette::sim::Statistics statistics;
  statistics.boards.resize(1);
  statistics.bus.masters.resize(1);
  statistics.bus.masters[0].waited_for.resize(1);
  statistics.bus.masters[0].waits.resize(1);
  statistics.bus.queue.times.resize(1);
  statistics.roots.intersections.emplace().by_steps.resize(1);
  const auto values = maquette::sim::flatten_json(maquette::sim::statistics_json(statistics), "s");
  REQUIRE(values.size() > 60);
  for (const auto& [path, value] : values) {
    std::string key = std::regex_replace(path, std::regex("\\[0\\]"), "[]");
    key = std::regex_replace(
        key, std::regex("(work|costs\\.clocks|functions\\.time_by_function_s)\\..*"), "$1");
    INFO(key);
    CHECK(("\n" + description).find("\n" + key + " ") != std::string::npos);
  }
}
