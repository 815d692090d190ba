#include <algorithm>
#include <map>
#include <set>

#include "sim/report/scalar_statistics.hpp"
#include "tests/catch.hpp"
#include "tests/sim/report/random_statistics.hpp"

using namespace maquette::sim;

namespace {

std::map<std::string, ScalarStatistic> by_name(const Statistics& statistics) {
  std::map<std::string, ScalarStatistic> map;
  for (const ScalarStatistic& scalar : scalar_statistics(statistics)) {
    CHECK(map.emplace(scalar.name, scalar).second);
  }
  return map;
}

}  // namespace

TEST_CASE("scalars have the declared names, units and exact values") {
  Statistics statistics;
  statistics.frame.time = maquette::models::Duration(422'500'000'000'001);
  statistics.bus.utilisation = 0.1;
  statistics.work[0] = 7;
  statistics.end_reason = "all boards are done";
  const auto scalars = by_name(statistics);
  CHECK(scalars.at("frame.time_s").text == "422.500000000001");
  CHECK(scalars.at("frame.time_s").unit == "s");
  CHECK_FALSE(scalars.at("frame.time_s").sentence.empty());
  CHECK(scalars.at("bus.utilisation").text == "0.1");
  CHECK(scalars.at(std::string("work.") + maquette::firmware::k_operation_names[0]).text == "7");
  CHECK(scalars.at("partial").text == "false");
  CHECK(scalars.at("end_reason").text == "all boards are done");
}

TEST_CASE("means are right where the sum is longer than a time can be") {
  Statistics statistics;
  const maquette::models::Duration hundred_days(8'640'000'000'000'000'000);
  statistics.boards.resize(256);
  for (auto& board : statistics.boards) {
    board.compute = hundred_days;
    board.pixels = 9'000'000'000'000'000'000;
  }
  const auto scalars = by_name(statistics);
  CHECK(scalars.at("boards.compute_s.mean").text == "8640000");
  CHECK(scalars.at("boards.pixels.mean").text == "9e+18");
}

TEST_CASE("lists of groups give least, mean and greatest") {
  Statistics statistics;
  statistics.boards.resize(3);
  const std::vector<std::int64_t> pixels{5, 1, 4};
  for (std::size_t i = 0; i < 3; ++i) {
    statistics.boards[i].pixels = pixels[i];
    statistics.boards[i].idle = maquette::models::Duration(pixels[i]);
  }
  const auto scalars = by_name(statistics);
  CHECK(scalars.at("boards.pixels.min").text == "1");
  CHECK(scalars.at("boards.pixels.mean").text == "3.3333333333333335");
  CHECK(scalars.at("boards.pixels.max").text == "5");
  CHECK(scalars.at("boards.idle_s.mean").text == "0.000000000003");
  CHECK(scalars.count("boards.name.min") == 0);
}

TEST_CASE("names do not depend on values") {
  std::mt19937_64 random{3};
  const auto plain = scalar_statistics({});
  Statistics statistics;
  statistics.boards.resize(2);
  const auto others = scalar_statistics(statistics);
  REQUIRE(plain.size() == others.size());
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(plain[i].name == others[i].name);
  }
}
