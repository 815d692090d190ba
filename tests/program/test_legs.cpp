#include <sstream>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

constexpr const char* k_scenes = MAQUETTE_PROJECT_DIRECTORY "/scenes/";

/// The numbers of the row of a table that begins with a name.
std::vector<double> row_of(const std::string& table, const std::string& name) {
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string first;
    words >> first;
    std::vector<double> numbers;
    for (double number = 0; first == name && words >> number;) {
      numbers.push_back(number);
    }
    if (!numbers.empty()) {
      return numbers;
    }
  }
  return {};
}

}  // namespace

TEST_CASE("A scene's legs are shown by stage and primitive, and sum to the whole") {
  const Outcome outcome = run_maquette("describe " + std::string(k_scenes) + "photo1.yaml --legs " +
                                       "--set frame_memory.width='60 pixels' " +
                                       "--set frame_memory.height='40 pixels'");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  std::vector<double> sum(5);
  for (const char* stage : {"board", "extents", "intersection", "combination", "photometry"}) {
    const std::vector<double> row = row_of(outcome.output, stage);
    INFO(stage);
    REQUIRE(row.size() == 5);
    CHECK(row[0] > 0);
    sum[0] += row[0];
    sum[4] += row[4];
  }
  CHECK(row_of(outcome.output, "all")[0] == Approx(sum[0]).margin(0.03));
  CHECK(sum[4] == Approx(100).margin(0.3));
  CHECK_THAT(outcome.output, ContainsSubstring("  intersection_"));
}

TEST_CASE("A machine has no legs to show") {
  const Outcome outcome = run_maquette("describe ccett-1984 --legs");
  CHECK(outcome.exit_code == 2);
  CHECK_THAT(outcome.errors, ContainsSubstring("allowed with --legs: a scene"));
}
