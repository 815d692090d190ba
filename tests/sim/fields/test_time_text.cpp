#include "sim/fields/time_text.hpp"

#include <stdexcept>

#include "sim/fields/quantity.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

using Catch::Matchers::ContainsSubstring;

constexpr std::int64_t k_second = 1'000'000'000'000;

TEST_CASE("Times are numbers with units, after minutes and hours") {
  CHECK(parse_time("9 min") == 540 * k_second);
  CHECK(parse_time("9min") == 540 * k_second);
  CHECK(parse_time("1.5 min") == 90 * k_second);
  CHECK(parse_time("6 min 59 s") == 419 * k_second);
  CHECK(parse_time("  6 min  59.5 s") == 419 * k_second + k_second / 2);
  CHECK(parse_time("1 h 2 min 3 s") == 3723 * k_second);
  CHECK(parse_time("2 h") == 7200 * k_second);
  CHECK(parse_time("2 h 1 ms") == 7200 * k_second + k_second / 1000);
}

TEST_CASE("Times without minutes are as in descriptions") {
  for (const char* text : {"60 s", "0 s", "1ps", "12.5 us", "3 ms", "-1 s"}) {
    CHECK(parse_time(text) == parse_quantity(text, WholeDimension::time));
  }
}

TEST_CASE("What is no time is answered with what is allowed") {
  for (const char* text : {"", "9", "9 minutes", "min", "6 min 59", "6 s 5 min", "6 min 5 h",
                           "6 min -5 s", "1e30 min", "5 hours"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_time(text), std::invalid_argument);
  }
  CHECK_THROWS_WITH(parse_time("9 minutes"), ContainsSubstring("6 min 59 s"));
}

}  // namespace
}  // namespace maquette::sim
