#include "sim/sweep/line_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>
#include <utility>

#include "tests/catch.hpp"
#include "tests/sim/plot/script_text.hpp"

using namespace maquette::sim;
using maquette::tests::contains;
using maquette::tests::data_block;
using maquette::tests::has_line;

namespace {

/// Rows of x, y and series.
using Rows = std::vector<std::vector<std::string>>;

std::string script_of(const Rows& rows, bool has_series, bool log_x = false, bool log_y = false) {
  const Study study;
  const Table table{{{"x", "us", "how long"}, {"y", "s", ""}, {"name", "", ""}}, rows};
  Plot plot;
  plot.x = "x";
  plot.y = "y";
  plot.series = has_series ? "name" : "";
  plot.log_x = log_x;
  plot.log_y = log_y;
  return line_script(plot, {study, table, std::vector<bool>(rows.size())});
}

}  // namespace

TEST_CASE("texts stand along the axis in the order in which they come") {
  const std::string script =
      script_of({{"round_robin", "3", ""}, {"daisy", "5", ""}, {"round_robin", "4", ""}}, false);
  CHECK(has_line(script, "set xtics ('round_robin' 0, 'daisy' 1)"));
  CHECK(has_line(script, "set xrange [-0.5:1.5]"));
  CHECK(data_block(script, "series0") == std::vector<std::vector<double>>{{0, 3}, {1, 5}, {0, 4}});
  // One text among numbers makes texts of all; a cell without a value does not.
  CHECK(contains(script_of({{"2", "3", ""}, {"none", "5", ""}}, false), "('2' 0, 'none' 1)"));
  CHECK_FALSE(contains(script_of({{"2", "3", ""}, {"", "5", ""}}, false), "set xtics"));
}

TEST_CASE("points are joined unless a series has two at one place") {
  CHECK(contains(script_of({{"1", "3", "a"}, {"2", "4", "a"}}, true), "with linespoints"));
  CHECK(contains(script_of({{"1", "3", "a"}, {"1", "4", "b"}}, true), "with linespoints"));
  const std::string twice = script_of({{"1", "3", "a"}, {"1", "4", "a"}}, true);
  CHECK(contains(twice, "with points"));
  CHECK_FALSE(contains(twice, "with linespoints"));
}

TEST_CASE("an axis starts at zero where the least value is below half of the greatest") {
  std::mt19937 random(3);
  for (int round = 0; round < 300; ++round) {
    Rows rows;
    std::vector<int> values;
    for (std::size_t i = 0; i < 1 + random() % 6; ++i) {
      values.push_back(static_cast<int>(random() % 40) + (round % 2) * 20 - 5);
      rows.push_back(
          {fmt::format("{}", i), fmt::format("{}", values.back()), random() % 2 == 0 ? "a" : "b"});
    }
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    const bool from_zero = *least >= 0 && 2 * *least < *greatest;
    CHECK(has_line(script_of(rows, true), "set yrange [0:*]") == from_zero);
    CHECK_FALSE(has_line(script_of(rows, true, false, true), "set yrange [0:*]"));
  }
}

TEST_CASE("a logarithmic axis has a tic at each value, unless they would touch") {
  const Rows few{{"8", "3", ""}, {"1", "4", ""}, {"64", "5", ""}, {"8", "6", ""}};
  const std::string script = script_of(few, false, true);
  CHECK(has_line(script, "set logscale x"));
  CHECK(has_line(script, "set xtics (1, 8, 64)"));
  CHECK_FALSE(contains(script_of(few, false), "set xtics"));
  for (const int values : {16, 17}) {
    Rows rows;
    for (int i = 1; i <= values; ++i) {
      rows.push_back({fmt::format("{}", i), "1", ""});
    }
    CHECK(contains(script_of(rows, false, true), "set xtics (") == (values == 16));
  }
  // Places of texts have no logarithm.
  CHECK_FALSE(has_line(script_of({{"a", "3", ""}}, false, true), "set logscale x"));
  CHECK(has_line(script_of(few, false, false, true), "set logscale y"));
}

TEST_CASE("a row without a number is left out, and nothing else") {
  const std::string script =
      script_of({{"1", "3", "a"}, {"2", "", "a"}, {"", "4", "a"}, {"3", "5", "b"}}, true);
  CHECK(data_block(script, "series0") == std::vector<std::vector<double>>{{1, 3}});
  CHECK(data_block(script, "series1") == std::vector<std::vector<double>>{{3, 5}});
  CHECK(contains(script, "linetype 1 title 'a', $series1"));
  CHECK(contains(script, "linetype 2 title 'b'"));
  CHECK(contains(script_of({}, false), "plot NaN notitle"));
}
