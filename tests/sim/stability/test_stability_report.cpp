#include "sim/stability/stability_report.hpp"

#include <nlohmann/json.hpp>

#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

std::vector<StabilityMeasurement> measurements() {
  return {{"float",
           {{"roots", "cluster", "parity errors", 3, 0}, {"csg", "boxes", "rays", 1000000, {}}}},
          {"double",
           {{"roots", "cluster", "parity errors", 0, 0}, {"csg", "boxes", "rays", 1000000, {}}}}};
}

TEST_CASE("Broken bounds are counted over all number types") {
  CHECK(broken_bounds(measurements()) == 1);
  std::vector<StabilityMeasurement> sound = measurements();
  sound[0].rows[0].value = 0;
  CHECK(broken_bounds(sound) == 0);
  CHECK(broken_bounds({}) == 0);
}

TEST_CASE("The table shows a line for each figure, its values side by side, a mark where broken") {
  const std::string table = stability_table(measurements());
  const std::size_t line = table.find("parity errors");
  REQUIRE(line != std::string::npos);
  const std::string values = table.substr(line, table.find('\n', line) - line);
  CHECK_THAT(values, Catch::Matchers::Matches("parity errors *! 3 *0 *0 *0 *"));
  CHECK_THAT(table, Catch::Matchers::ContainsSubstring("1000000"));
  CHECK(table.find("roots\n") < table.find("csg\n"));
}

TEST_CASE("The JSON holds every row with its number type") {
  const auto json = nlohmann::json::parse(stability_json(measurements()));
  CHECK(json["broken_bounds"] == 1);
  REQUIRE(json["rows"].size() == 4);
  CHECK(json["rows"][0]["scalar"] == "float");
  CHECK(json["rows"][0]["case"] == "cluster");
  CHECK(json["rows"][0]["value"] == 3);
  CHECK(json["rows"][0]["bound"] == 0);
  CHECK(json["rows"][0]["holds"] == false);
  CHECK(json["rows"][1]["bound"].is_null());
  CHECK(json["rows"][2]["holds"] == true);
}

}  // namespace
}  // namespace maquette::sim
