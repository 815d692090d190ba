#include "sim/sweep/histogram_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/catch.hpp"
#include "tests/sim/plot/script_text.hpp"

using namespace maquette::sim;
using maquette::tests::contains;
using maquette::tests::data_block;

namespace {

std::string script_of(const std::vector<double>& results, StudyDesign design) {
  Study study;
  study.design = design;
  Table table{{{"point", "", ""}, {"t", "s", ""}}, {}};
  for (const double result : results) {
    table.rows.push_back({fmt::format("{}", table.rows.size()), fmt::format("{}", result)});
  }
  Plot plot;
  plot.kind = PlotKind::histogram;
  plot.y = "t";
  return histogram_script(plot, {study, table, std::vector<bool>(results.size())});
}

}  // namespace

TEST_CASE("the bins tile what the results span, and each counts those that lie in it") {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> results;
    for (std::size_t i = 0; i < 2 + random() % 500; ++i) {
      results.push_back(static_cast<double>(random() % 100'000) / 64);
    }
    const auto [least, greatest] = std::minmax_element(results.begin(), results.end());
    if (*least == *greatest) {
      continue;
    }
    const auto bins = data_block(script_of(results, StudyDesign::grid), "bins");
    const int expected_bins = std::clamp(static_cast<int>(std::sqrt(results.size())), 5, 60);
    REQUIRE(bins.size() == static_cast<std::size_t>(expected_bins));
    double counted = 0;
    for (std::size_t i = 0; i < bins.size(); ++i) {
      const double begin = bins[i][0] - bins[i][2] / 2;
      const double end = bins[i][0] + bins[i][2] / 2;
      CHECK(begin == Approx(*least + static_cast<double>(i) * (*greatest - *least) / expected_bins)
                         .margin(1e-9));
      const double rounding = 1e-9 * *greatest;
      const auto within = [&](double more) {
        return static_cast<double>(std::count_if(results.begin(), results.end(), [&](double r) {
          return r >= begin - more && r < end + more;
        }));
      };
      CHECK(bins[i][1] <= within(rounding));
      CHECK(bins[i][1] >= within(-rounding));
      counted += bins[i][1];
    }
    CHECK(counted == static_cast<double>(results.size()));
  }
}

TEST_CASE("a histogram does not depend on the order of the points") {
  std::vector<double> results{4, 1, 3, 1, 8, 2.5, 7};
  const std::string script = script_of(results, StudyDesign::grid);
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    std::shuffle(results.begin(), results.end(), random);
    CHECK(script_of(results, StudyDesign::grid) == script);
  }
}

TEST_CASE("the middle and the limits of 90 % are where quantiles have them") {
  std::vector<double> results(101);
  for (int i = 0; i <= 100; ++i) {
    results[static_cast<std::size_t>(i)] = 100 - i;
  }
  const std::string script = script_of(results, StudyDesign::grid);
  CHECK(contains(script, "set object rectangle from 5, graph 0 to 95, graph 1 "));
  CHECK(contains(script, "set arrow from 50, graph 0 to 50, graph 1 "));
  CHECK(contains(script, "'90 % within 5 to 95 s'"));
  CHECK(contains(script, "'median 50 s'"));
  CHECK_FALSE(contains(script, "as described"));
}

TEST_CASE("the plain point is marked and not counted") {
  const std::string script = script_of({1000, 1, 2, 3}, StudyDesign::latin_hypercube);
  CHECK(contains(script, "set arrow from 1000, graph 0 to 1000, graph 1 "));
  CHECK(contains(script, "'as described: 1000 s'"));
  double counted = 0;
  for (const auto& bin : data_block(script, "bins")) {
    CHECK(bin[0] < 4);
    counted += bin[1];
  }
  CHECK(counted == 3);
}

TEST_CASE("results that are all alike fill one bin, and none make an empty plot") {
  for (const double alike : {0.0, 7.0, -3e6}) {
    const auto bins = data_block(script_of({alike, alike, alike}, StudyDesign::grid), "bins");
    REQUIRE(bins.size() == 5);
    CHECK(std::count_if(bins.begin(), bins.end(), [](const auto& bin) { return bin[1] == 3; }) ==
          1);
  }
  CHECK(contains(script_of({}, StudyDesign::grid), "plot NaN notitle"));
}
