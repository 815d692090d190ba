#include <limits>
#include <random>
#include <string>

#include "sim/report/seconds.hpp"
#include "tests/catch.hpp"

using maquette::models::Duration;
using maquette::sim::format_seconds;
using maquette::sim::parse_seconds;
using maquette::sim::readable_duration;

namespace {

// The law itself: digits of the integer count, the point twelve places from the right.
std::int64_t ticks_of_decimal(std::string text) {
  const auto point = text.find('.');
  const auto decimals = point == std::string::npos ? 0 : text.size() - point - 1;
  if (point != std::string::npos) {
    text.erase(point, 1);
  }
  return std::stoll(text + std::string(12 - decimals, '0'));
}

}  // namespace

TEST_CASE("seconds are exact decimals for every count of picoseconds") {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto bits = static_cast<int>(random() % 63);
    const auto magnitude = static_cast<std::int64_t>(random() >> (63 - bits) >> 1);
    const std::int64_t ticks = random() % 2 == 0 ? magnitude : -magnitude;
    const std::string text = format_seconds(Duration(ticks));
    REQUIRE(ticks_of_decimal(text) == ticks);
    REQUIRE(parse_seconds(text) == Duration(ticks));
    REQUIRE((text.find('.') == std::string::npos || text.back() != '0'));
  }
}

TEST_CASE("seconds at the ends of the range") {
  constexpr auto largest = std::numeric_limits<std::int64_t>::max();
  CHECK(format_seconds(Duration(0)) == "0");
  CHECK(format_seconds(Duration(1)) == "0.000000000001");
  CHECK(format_seconds(Duration(-1)) == "-0.000000000001");
  CHECK(format_seconds(Duration(422'500'000'000'000)) == "422.5");
  CHECK(format_seconds(Duration(60'000'000'000'000)) == "60");
  CHECK(format_seconds(Duration(largest)) == "9223372.036854775807");
  CHECK(format_seconds(Duration(-largest - 1)) == "-9223372.036854775808");
  CHECK(parse_seconds("9223372.036854775807") == Duration(largest));
}

TEST_CASE("what is no exact count of picoseconds is refused") {
  for (const char* text : {"", "-", ".", "1.", ".5", "1e3", "+1", " 1", "1 ", "--1", "1.-5", "nan",
                           "0.0000000000001", "9223372.036854775808", "99999999999999999999"}) {
    INFO(text);
    CHECK_FALSE(parse_seconds(text).has_value());
  }
}

TEST_CASE("durations for the eye") {
  using namespace std::chrono_literals;
  CHECK(readable_duration(0s) == "0 s");
  CHECK(readable_duration(Duration(7)) == "7 ps");
  CHECK(readable_duration(999ns) == "999 ns");
  CHECK(readable_duration(2500ns) == "2.5 us");
  CHECK(readable_duration(312ms) == "312 ms");
  CHECK(readable_duration(999'800us) == "1 s");
  CHECK(readable_duration(59'940ms) == "59.9 s");
  CHECK(readable_duration(59'960ms) == "1 min 00.0 s");
  CHECK(readable_duration(422'480ms) == "7 min 02.5 s");
  CHECK(readable_duration(7'199'960ms) == "120 min 00.0 s");
}
