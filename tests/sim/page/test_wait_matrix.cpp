#include "sim/page/wait_matrix.hpp"

#include "sim/report/seconds.hpp"
#include "tests/catch.hpp"
#include "tests/sim/page/well_formed.hpp"

using namespace maquette::sim;
using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

/// Masters of which each waits for each other a time of its own.
BusStatistics bus_of(std::size_t masters) {
  BusStatistics bus;
  for (std::size_t i = 0; i < masters; ++i) {
    bus.masters.push_back({});
    bus.masters.back().name = "board" + std::to_string(i);
    for (std::size_t other = 0; other < masters; ++other) {
      bus.masters.back().waited_for.emplace_back(static_cast<std::int64_t>(1000 * i + other + 1));
    }
  }
  return bus;
}

}  // namespace

TEST_CASE("Of few masters, every wait for every other stands in the matrix") {
  const BusStatistics bus = bus_of(5);
  const std::string markup = wait_matrix(bus).markup;
  CHECK(ill_formed(markup).empty());
  for (const MasterStatistics& master : bus.masters) {
    CHECK_THAT(markup, ContainsSubstring(">for " + master.name + "<"));
    for (const auto time : master.waited_for) {
      CHECK_THAT(markup, ContainsSubstring(">" + format_seconds(time) + "<"));
    }
  }
  CHECK_THAT(markup, ContainsSubstring("--shade:1.000"));
}

TEST_CASE("Of many masters, the pairs that waited longest stand in a list") {
  const std::string markup = wait_matrix(bus_of(256)).markup;
  CHECK(ill_formed(markup).empty());
  CHECK(markup.size() < 20'000);
  CHECK_THAT(markup,
             ContainsSubstring("<th scope=\"row\">board255</th>\n<td>itself (arbitration)"));
  CHECK_THAT(markup, !ContainsSubstring("board100<"));
}

TEST_CASE("Without masters there is no matrix") { CHECK(wait_matrix({}).markup.empty()); }
