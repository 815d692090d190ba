#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>

#include "sim/report/statistics_json.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/report/random_statistics.hpp"

using maquette::models::Duration;
using maquette::sim::DescriptionError;
using maquette::sim::parse_statistics;
using maquette::sim::Statistics;
using maquette::sim::statistics_json;
using maquette::tests::random_statistics;

namespace {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("statistics read back as they were written, to the last tick and bit") {
  std::mt19937_64 random(5);
  for (int i = 0; i < 300; ++i) {
    const Statistics written = random_statistics(random);
    const std::string text = statistics_json(written);
    const Statistics read = parse_statistics(text, "stats.json");
    REQUIRE(statistics_json(read) == text);
    REQUIRE(read.frame.time == written.frame.time);
    REQUIRE(read.bus.utilisation == written.bus.utilisation);
    REQUIRE(read.bus.masters.size() == written.bus.masters.size());
    REQUIRE(read.boards.size() == written.boards.size());
    for (std::size_t board = 0; board < read.boards.size(); ++board) {
      REQUIRE(read.boards[board].name == written.boards[board].name);
      REQUIRE(read.boards[board].idle == written.boards[board].idle);
    }
    REQUIRE(read.work == written.work);
    REQUIRE(read.partial == written.partial);
    REQUIRE(read.end_reason == written.end_reason);
  }
}

TEST_CASE("stats.json is JSON with the keys that other programs rely on") {
  Statistics statistics;
  statistics.frame.time = Duration(422'123'456'789'012);
  statistics.boards.resize(2);
  statistics.boards[1].compute = Duration(1);
  statistics.work[static_cast<int>(maquette::firmware::Operation::multiply)] = 7;
  statistics.end_reason = "last pixel";
  const auto json = nlohmann::ordered_json::parse(statistics_json(statistics));
  std::vector<std::string> keys;
  for (const auto& item : json.items()) {
    keys.push_back(item.key());
  }
  CHECK(keys == std::vector<std::string>{"frame", "useful_zone", "boards", "bus", "rays", "roots",
                                         "work", "preprocess_work", "costs", "functions", "extents",
                                         "partial", "end_reason"});
  for (const char* key : {"width", "height", "time_s", "load_s", "preprocess_s", "synthesis_s",
                          "pixels_total", "pixels_synthesised"}) {
    CHECK(json["frame"].contains(key));
  }
  for (const char* key : {"name", "pixels", "compute_s", "wait_grant_s", "transfer_s", "idle_s"}) {
    CHECK(json["boards"][1].contains(key));
  }
  for (const char* key : {"transfers", "busy_s", "utilisation", "wait_mean_s", "wait_max_s"}) {
    CHECK(json["bus"].contains(key));
  }
  for (const char* key : {"primary", "reflected", "refracted", "shadow"}) {
    CHECK(json["rays"].contains(key));
  }
  CHECK(json["work"].size() == maquette::firmware::k_operation_count);
  CHECK(json["work"]["multiply"] == 7);
  CHECK(json["partial"] == false);
  CHECK(json["end_reason"] == "last pixel");
  CHECK(statistics_json(statistics).find("\"time_s\": 422.123456789012,") != std::string::npos);
  CHECK(statistics_json(statistics).find("\"compute_s\": 0.000000000001,") != std::string::npos);
}

TEST_CASE("statistics that are not whole are refused with the key") {
  std::mt19937_64 random(6);
  const std::string text = statistics_json(random_statistics(random));
  const auto parse = [](const std::string& json) { return parse_statistics(json, "stats.json"); };
  CHECK_NOTHROW(parse(text));
  CHECK_THROWS_WITH(parse(replaced(text, "\"load_s\"", "\"lode_s\"")),
                    Catch::Matchers::ContainsSubstring("stats.json") &&
                        Catch::Matchers::ContainsSubstring("frame.load_s"));
  CHECK_THROWS_WITH(parse(replaced(text, "\"partial\":", "\"spare\": 1, \"partial\":")),
                    Catch::Matchers::ContainsSubstring("unknown key spare"));
  CHECK_THROWS_WITH(parse(replaced(text, "\"partial\": ", "\"partial\": 2, \"spare\": ")),
                    Catch::Matchers::ContainsSubstring("partial") &&
                        Catch::Matchers::ContainsSubstring("true or false"));
  CHECK_THROWS_WITH(parse(replaced(text, "\"width\": ", "\"width\": 0.5, \"spare\": ")),
                    Catch::Matchers::ContainsSubstring("frame.width") &&
                        Catch::Matchers::ContainsSubstring("a whole number"));
  CHECK_THROWS_WITH(parse(replaced(text, "\"load_s\": ", "\"load_s\": \"soon\", \"spare\": ")),
                    Catch::Matchers::ContainsSubstring("frame.load_s"));
  for (std::size_t length = 0; length + 2 < text.size(); length += 37) {
    REQUIRE_THROWS_AS(parse(text.substr(0, length)), DescriptionError);
  }
}

TEST_CASE("a real that JSON cannot hold is refused") {
  Statistics statistics;
  statistics.bus.utilisation = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_AS(statistics_json(statistics), std::invalid_argument);
  const std::string text = statistics_json({});
  for (const char* number : {"inf", "-inf", "nan"}) {
    const std::string wrong =
        replaced(text, "\"imbalance\": 0", "\"imbalance\": \"" + std::string(number) + "\"");
    CHECK_THROWS_WITH(parse_statistics(wrong, "stats.json"),
                      Catch::Matchers::ContainsSubstring("must be a number"));
  }
}
