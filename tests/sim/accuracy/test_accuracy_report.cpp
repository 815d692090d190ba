#include "sim/accuracy/accuracy_report.hpp"

#include <chrono>
#include <sstream>

#include "tests/catch.hpp"
#include "tests/sim/plot/script_text.hpp"

using namespace maquette::sim;
using maquette::models::Duration;
using maquette::tests::contains;

namespace {

/// A reference and a level that is off, of two boards.
LadderResult two_levels() {
  LadderResult result{{"bus", "how the bus is timed", ErrorMeasure::frame_time, {}, 0}, {}};
  result.ladder.levels = {{"exact", {}}, {"coarse", {}}};
  const Duration second = std::chrono::duration_cast<Duration>(std::chrono::seconds(1));
  LevelResult exact;
  exact.simulated = SimulatedTimes{100 * second, {second, 2 * second}, 8e9};
  exact.error.simulated = SimulatedError{{Duration::zero(), 0.0}, {}, {}};
  exact.error.tiles = TileError{};
  exact.host = {2, 1, 3, 5};
  exact.is_on_host_front = true;
  LevelResult coarse = exact;
  coarse.simulated->frame = 99 * second;
  coarse.error.simulated =
      SimulatedError{{-1 * second, -0.01}, {}, TimeError{Duration{second.count() / 4}, 0.125}};
  coarse.error.picture = {7, 0.25, 12};
  coarse.error.tiles = TileError{{}, {}, 0.001, 0.02, 0.3};
  coarse.host = {0.5, 0.25, 1, 5};
  coarse.is_on_host_front = false;
  coarse.is_on_simulated_front = true;
  result.levels = {exact, coarse};
  return result;
}

/// The words of the first line that begins with a level's name, and those of its tiles.
std::vector<std::string> words_of(const std::string& report, const std::string& name,
                                  bool of_tiles) {
  std::istringstream lines(report);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::vector<std::string> result;
    for (std::string word; words >> word;) {
      result.push_back(word);
    }
    if (!result.empty() && result[0] == name && contains(line, "per tile") == of_tiles) {
      return result;
    }
  }
  return {};
}

using Words = std::vector<std::string>;

}  // namespace

TEST_CASE("a line says what a level costs and how far it is off") {
  const std::string report = accuracy_report({two_levels()});
  CHECK(contains(report, "\nbus: how the bus is timed; reference: exact\n"));
  CHECK(words_of(report, "exact", false) == Words{"exact", "2.000", "s", "4000", "h", "1", "min",
                                                  "40.0", "s", "+0", "%", "0", "0", "0"});
  CHECK(words_of(report, "coarse", false) == Words{"coarse", "0.500", "s", "16000", "s", "1", "min",
                                                   "39.0", "s", "-1", "%", "+0.25", "+12.5", "%",
                                                   "0.25", "7", "12"});
}

TEST_CASE("the tiles of a level are told, but for those of the reference") {
  const std::string report = accuracy_report({two_levels()});
  CHECK(words_of(report, "exact", true).empty());
  CHECK(contains(report, "off by 0.1 % (median), 2 % (95 % of the tiles), 30 % (worst)\n"));
  LadderResult without = two_levels();
  without.levels[1].error.tiles.reset();
  CHECK_FALSE(contains(accuracy_report({without}), "per tile"));
}

TEST_CASE("a level that is not simulated has neither rate nor errors of time") {
  LadderResult result = two_levels();
  result.levels[1].simulated.reset();
  result.levels[1].error.simulated.reset();
  result.levels[1].error.tiles.reset();
  CHECK(words_of(accuracy_report({result}), "coarse", false) ==
        Words{"coarse", "0.500", "s", "s", "0.25", "7", "12"});
}
