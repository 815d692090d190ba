#include "sim/report/statistics_json.hpp"
#include "sim/sweep/point_result.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/report/random_statistics.hpp"

using namespace maquette::sim;

TEST_CASE("a point's statistics are read back without loss") {
  std::mt19937_64 random{11};
  for (int i = 0; i < 50; ++i) {
    const Statistics statistics = maquette::tests::random_statistics(random);
    const std::string json =
        point_json(i, {{"machine", "a \"b\""}, {"processors", "4"}}, "digest", {statistics, ""});
    const PointFile file = parse_point(json, "p.json");
    CHECK(file.study == "digest");
    REQUIRE(file.result.statistics);
    CHECK(statistics_json(*file.result.statistics) == statistics_json(statistics));
  }
}

TEST_CASE("a point's failure is read back") {
  const std::string reason = "bus: \"no\"\nanswer";
  const PointFile file = parse_point(point_json(3, {}, "d", {std::nullopt, reason}), "p.json");
  CHECK_FALSE(file.result.statistics);
  CHECK(file.result.failure == reason);
}

TEST_CASE("damaged points are refused") {
  const std::string json = point_json(3, {{"a", "1"}}, "d", {Statistics{}, ""});
  CHECK_THROWS_AS(parse_point(json.substr(0, json.size() / 2), "p.json"), DescriptionError);
  CHECK_THROWS_AS(parse_point("{}", "p.json"), DescriptionError);
}
