#include <cmath>
#include <random>

#include "sim/sweep/value_range.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"

using namespace maquette::sim;

namespace {

std::string texts_of(const std::string& text, bool is_whole = false) {
  const auto range = read_range(text, {});
  REQUIRE(range);
  std::string result;
  for (const Measure& measure : values_of(*range, is_whole)) {
    result += (result.empty() ? "" : "|") + write_measure(measure);
  }
  return result;
}

double random_share(std::mt19937& random) { return static_cast<double>(random()) / 4294967296.0; }

}  // namespace

TEST_CASE("ranges give their values with their unit, both ends included") {
  CHECK(texts_of("1..4") == "1|2|3|4");
  CHECK(texts_of("1..64:21") == "1|22|43|64");
  CHECK(texts_of("1..10:4") == "1|5|9");
  CHECK(texts_of("2..4 clocks") == "2 clocks|3 clocks|4 clocks");
  CHECK(texts_of("8..10 MHz:0.5") == "8 MHz|8.5 MHz|9 MHz|9.5 MHz|10 MHz");
  CHECK(texts_of("8..9 MHz:500 kHz") == "8 MHz|8.5 MHz|9 MHz");
  CHECK(texts_of("200 ns..0.4 us:0.1") == "0.2 us|0.3 us|0.4 us");
  CHECK(texts_of("0.2..0.5 us of 4") == "0.2 us|0.3 us|0.4 us|0.5 us");
  CHECK(texts_of("log 1..1000 of 4") == "1|10|100|1000");
  CHECK(texts_of("0..0.3:0.1") == "0|0.1|0.2|0.3");
  CHECK(texts_of("-1..1") == "-1|0|1");
}

TEST_CASE("whole numbers are rounded and never given twice") {
  CHECK(texts_of("log 1..10 of 9", true) == "1|2|3|4|6|7|10");
  CHECK(texts_of("0..1 us of 4", true) == "0 us|0.333333 us|0.666667 us|1 us");
  CHECK(texts_of("1..2 KiB of 4", true) ==
        "1 KiB|1.3330078125 KiB|1.6669921875 KiB|2 KiB");  // 1365 B, 1707 B
}

TEST_CASE("what is no range is left to others") {
  for (const char* text :
       {"../scenes/photo4.yaml", "a..b", "1.5", "priority", "", "log", "8 MHz"}) {
    INFO(text);
    CHECK_FALSE(read_range(text, {}));
  }
}

TEST_CASE("ranges that make no sense are refused") {
  for (const char* text :
       {"4..1", "1..1", "1..", "1..x", "1..4 of 1", "1..4 of x", "1..4:0", "1..4:-1", "1..4:1 of 3",
        "log 0..4 of 3", "log 1..4:1", "1 MHz..4 clocks", "1..4 parsecs", "1 MHz..4"}) {
    INFO(text);
    CHECK_THROWS_AS(static_cast<void>(read_range(text, {})), DescriptionError);
  }
  for (const char* text : {"0.5..3", "log 1..10", "1..1e9"}) {
    INFO(text);
    CHECK_THROWS_AS(static_cast<void>(values_of(*read_range(text, {}), false)), DescriptionError);
  }
}

TEST_CASE("values of random ranges stay inside, grow, and reach both ends") {
  std::mt19937 random{5};
  for (int i = 0; i < 2000; ++i) {
    ValueRange range;
    range.first = std::exp(20 * (random_share(random) - 0.5));
    range.last = range.first * (1.01 + 100 * random_share(random));
    range.is_logarithmic = random() % 2 == 0;
    range.count = 2 + static_cast<int>(random() % 30);
    const auto values = values_of(range, false);
    CHECK(values.front().value == range.first);
    CHECK(values.back().value == range.last);
    for (std::size_t j = 1; j < values.size(); ++j) {
      CHECK(values[j - 1].value < values[j].value);
    }
    for (int j = 0; j < 20; ++j) {
      const double value = value_at(range, false, random_share(random)).value;
      CHECK(value >= range.first);
      CHECK(value <= range.last);
    }
  }
}

TEST_CASE("few whole numbers are equally likely") {
  const auto range = *read_range("2..5 clocks", {});
  std::vector<int> counts(6);
  for (int i = 0; i < 400; ++i) {
    ++counts[static_cast<std::size_t>(value_at(range, true, i / 400.0).value)];
  }
  CHECK(counts == std::vector<int>{0, 0, 100, 100, 100, 100});
}
