#include <nlohmann/json.hpp>

#include "sim/accuracy/accuracy_json.hpp"
#include "sim/accuracy/accuracy_plot.hpp"
#include "sim/accuracy/accuracy_report.hpp"
#include "sim/accuracy/accuracy_tables.hpp"
#include "tests/catch.hpp"
#include "tests/sim/accuracy/random_ladders.hpp"

using namespace maquette::sim;
using maquette::tests::random_ladder;
using Json = nlohmann::json;

namespace {

std::vector<LadderResult> random_results(std::mt19937& random) {
  return {random_ladder(random, ErrorMeasure::frame_time),
          random_ladder(random, ErrorMeasure::picture)};
}

void check_same_row(const Table& table, std::size_t row, const Json& object) {
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    const std::string& cell = table.rows[row][column];
    const Json& value = object.at(table.columns[column].name);
    INFO(table.columns[column].name << ": " << cell << " and " << value);
    if (value.is_number()) {
      CHECK(std::stod(cell) == value.get<double>());
    } else {
      CHECK((value.is_null() ? "" : value.get<std::string>()) == cell);
    }
  }
}

}  // namespace

TEST_CASE("CSV and JSON agree row by row") {
  std::mt19937 random(11);
  for (int round = 0; round < 50; ++round) {
    const std::vector<LadderResult> results = random_results(random);
    const Table errors = error_table(results);
    const Json json = Json::parse(error_json("a \"scene\"", results));
    CHECK(json["scene"] == "a \"scene\"");
    std::size_t row = 0;
    for (std::size_t ladder = 0; ladder < results.size(); ++ladder) {
      const Json& levels = json["ladders"][ladder]["levels"];
      REQUIRE(levels.size() == results[ladder].levels.size());
      for (std::size_t i = 0; i < levels.size(); ++i) {
        CHECK(levels[i]["reference"] == results[ladder].ladder.reference_name());
        CHECK(levels[i]["boards"].size() == (results[ladder].levels[i].simulated ? 2 : 0));
        check_same_row(errors, row++, levels[i]);
      }
    }
    CHECK(row == errors.rows.size());

    const Table times = host_time_table(results);
    const Json time_rows = Json::parse(host_time_json(results))["levels"];
    REQUIRE(time_rows.size() == times.rows.size());
    for (std::size_t i = 0; i < times.rows.size(); ++i) {
      check_same_row(times, i, time_rows[i]);
    }
  }
}

TEST_CASE("the host's clock touches no other table than its own") {
  std::mt19937 random(12);
  std::vector<LadderResult> results = random_results(random);
  const std::string csv = table_csv(error_table(results));
  const std::string json = error_json("s", results);
  for (LadderResult& result : results) {
    for (LevelResult& level : result.levels) {
      level.host = {9, 8, 10, 77};
      level.is_on_host_front = !level.is_on_host_front;
    }
  }
  CHECK(table_csv(error_table(results)) == csv);
  CHECK(error_json("s", results) == json);
  CHECK(table_csv(host_time_table(results)).find(",77,") != std::string::npos);
}

TEST_CASE("the report and the plots name every level") {
  std::mt19937 random(13);
  const std::vector<LadderResult> results = random_results(random);
  const std::string report = accuracy_report(results);
  const std::vector<AccuracyPlot> plots = accuracy_plots(results);
  for (const Level& level : results[0].ladder.levels) {
    CHECK(report.find(level.name) != std::string::npos);
    CHECK(plots[0].script.find("set label '" + level.name + "'") != std::string::npos);
    CHECK(plots[1].script.find("set label '" + level.name + "'") != std::string::npos);
  }
  CHECK(plots[0].name == results[0].ladder.name + "-over-host-time");
  CHECK(plots[1].name == results[0].ladder.name + "-over-simulated-time");
}
