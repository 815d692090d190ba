#include "sim/accuracy/accuracy_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/report/seconds.hpp"
#include "tests/catch.hpp"
#include "tests/sim/accuracy/random_ladders.hpp"
#include "tests/sim/plot/script_text.hpp"

using namespace maquette::sim;
using maquette::tests::contains;
using maquette::tests::data_block;
using maquette::tests::has_line;
using maquette::tests::random_ladder;

namespace {

using Block = std::vector<std::vector<double>>;

/// A decade below the least error above zero, which stands for zero on a logarithmic axis.
double zero_of(const LadderResult& result) {
  double least = std::numeric_limits<double>::infinity();
  for (const LevelResult& level : result.levels) {
    least = level.magnitude > 0 ? std::min(least, level.magnitude) : least;
  }
  return std::isfinite(least) ? std::pow(10, std::floor(std::log10(least)) - 1) : 1e-3;
}

/// Time and error of the levels that are wanted, the least time first.
template <typename Time, typename Wanted>
Block expected(const LadderResult& result, Time time, Wanted wanted) {
  Block block;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    if (const LevelResult& level = result.levels[i]; wanted(level, i)) {
      block.push_back({time(level), std::max(level.magnitude, zero_of(result))});
    }
  }
  std::sort(block.begin(), block.end());
  return block;
}

Block sorted(Block block) {
  CHECK(std::is_sorted(block.begin(), block.end(),
                       [](const auto& a, const auto& b) { return a[0] < b[0]; }));
  std::sort(block.begin(), block.end());
  return block;
}

template <typename Time, typename OnFront>
void check_blocks(const LadderResult& result, const std::string& script, Time time,
                  OnFront on_front) {
  const auto front =
      expected(result, time, [&](const auto& l, std::size_t) { return on_front(l); });
  const auto others =
      expected(result, time, [&](const auto& l, std::size_t) { return !on_front(l); });
  CHECK(sorted(data_block(script, "front")) == front);
  CHECK(sorted(data_block(script, "others")) == others);
  CHECK(data_block(script, "reference") == expected(result, time, [&](const auto&, std::size_t i) {
          return i == result.ladder.reference;
        }));
  CHECK(contains(script, "$front using 1:2 with linespoints") == !front.empty());
  CHECK(contains(script, "$others using 1:2 with points") == !others.empty());
  CHECK(contains(script, "$reference using 1:2 with points"));
  CHECK(has_line(script, fmt::format("set ytics add ('0' {})", zero_of(result))));
}

}  // namespace

TEST_CASE("each level stands where its time and error put it, and the fronts are joined") {
  std::mt19937 random(21);
  for (int round = 0; round < 100; ++round) {
    const LadderResult result = random_ladder(random, ErrorMeasure::picture);
    const std::vector<AccuracyPlot> plots = accuracy_plots({result});
    const auto on_host = [](const LevelResult& level) { return level.host.median_s; };
    check_blocks(result, plots[0].script, on_host,
                 [](const LevelResult& level) { return level.is_on_host_front; });
    const bool is_simulated = result.levels.front().simulated.has_value();
    REQUIRE(plots.size() == (is_simulated ? 2 : 1));
    if (is_simulated) {
      const auto simulated = [](const LevelResult& l) { return in_seconds(l.simulated->frame); };
      check_blocks(result, plots[1].script, simulated,
                   [](const LevelResult& level) { return level.is_on_simulated_front; });
    }
  }
}

TEST_CASE("host times are drawn with what they spread over") {
  std::mt19937 random(22);
  const LadderResult result = random_ladder(random, ErrorMeasure::frame_time);
  const Block spreads = data_block(accuracy_plots({result})[0].script, "spreads");
  REQUIRE(spreads.size() == result.levels.size());
  for (std::size_t i = 0; i < spreads.size(); ++i) {
    const HostTimes& host = result.levels[i].host;
    CHECK(spreads[i][0] == host.median_s);
    CHECK(spreads[i][2] == host.least_s);
    CHECK(spreads[i][3] == host.most_s);
  }
}

TEST_CASE("host times that are more than a decade apart are drawn on a logarithmic axis") {
  std::mt19937 random(23);
  LadderResult result = random_ladder(random, ErrorMeasure::frame_time);
  const auto is_logarithmic = [&result](double least_s, double most_s) {
    for (LevelResult& level : result.levels) {
      level.host = {least_s, least_s, least_s, 3};
    }
    result.levels.back().host.most_s = most_s;
    return has_line(accuracy_plots({result})[0].script, "set logscale x");
  };
  CHECK(is_logarithmic(1, 10.5));
  CHECK_FALSE(is_logarithmic(1, 9.5));
  CHECK_FALSE(is_logarithmic(0, 9.5));
}

TEST_CASE("a ladder without any error has a place for zero") {
  std::mt19937 random(24);
  LadderResult result = random_ladder(random, ErrorMeasure::frame_time);
  for (LevelResult& level : result.levels) {
    level.magnitude = 0;
  }
  const std::string script = accuracy_plots({result})[0].script;
  CHECK(has_line(script, "set ytics add ('0' 0.001)"));
  CHECK(has_line(script, "set yrange [0.0005:*]"));
}
