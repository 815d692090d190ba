#include "sim/fields/quantity.hpp"

#include <clocale>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>

#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

constexpr WholeDimension k_whole_dimensions[] = {
    WholeDimension::count, WholeDimension::time,   WholeDimension::memory, WholeDimension::clocks,
    WholeDimension::bits,  WholeDimension::pixels, WholeDimension::lines};
constexpr RealDimension k_real_dimensions[] = {RealDimension::number, RealDimension::fraction,
                                               RealDimension::frequency, RealDimension::angle};

template <class Dimension>
std::string error_of(const char* text, Dimension dimension) {
  try {
    static_cast<void>(parse_quantity(text, dimension));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

}  // namespace

TEST_CASE("quantities are read in the units of their dimension") {
  CHECK(parse_quantity("8 MHz", RealDimension::frequency) == 8e6);
  CHECK(parse_quantity("14.75MHz", RealDimension::frequency) == 14.75e6);
  CHECK(parse_quantity("0.1 GHz", RealDimension::frequency) == 1e8);
  CHECK(parse_quantity("3 %", RealDimension::fraction) == 0.03);
  CHECK(parse_quantity("0.03", RealDimension::fraction) == 0.03);
  CHECK(parse_quantity("-30 deg", RealDimension::angle) == -30);
  CHECK(parse_quantity("1e-3", RealDimension::number) == 1e-3);
  CHECK(parse_quantity("+.5", RealDimension::number) == 0.5);
  CHECK(parse_quantity("625 ns", WholeDimension::time) == 625'000);
  CHECK(parse_quantity("62.5 ns", WholeDimension::time) == 62'500);
  CHECK(parse_quantity("0.000001 us", WholeDimension::time) == 1);
  CHECK(parse_quantity("2e3 s", WholeDimension::time) == 2'000'000'000'000'000);
  CHECK(parse_quantity("128 KiB", WholeDimension::memory) == 131072);
  CHECK(parse_quantity("0.5 KiB", WholeDimension::memory) == 512);
  CHECK(parse_quantity("4 clocks", WholeDimension::clocks) == 4);
  CHECK(parse_quantity("1 clock", WholeDimension::clocks) == 1);
}

TEST_CASE("a decimal fraction is rounded once: the scaled text is read, not the product") {
  // 0.1 * 1e6 and 100000.0 agree by luck; 4.35 * 1e6 does not.
  CHECK(parse_quantity("4.35 MHz", RealDimension::frequency) == 4350000.0);
  CHECK(parse_quantity("0.07 %", RealDimension::fraction) == 0.0007);
}

TEST_CASE("wrong and missing units name the allowed ones") {
  CHECK(error_of("8 Mhz", RealDimension::frequency) ==
        "`8 Mhz` has the unit `Mhz`; allowed: Hz, kHz, MHz, GHz");
  CHECK(error_of("8", RealDimension::frequency) == "`8` has no unit; allowed: Hz, kHz, MHz, GHz");
  CHECK(error_of("8 us", WholeDimension::memory) ==
        "`8 us` has the unit `us`; allowed: B, KiB, MiB");
  CHECK(error_of("8 m", RealDimension::number) ==
        "`8 m` has a unit; a plain number is allowed here");
  CHECK(error_of("3 e", RealDimension::angle) == "`3 e` has the unit `e`; allowed: deg");
}

TEST_CASE("a range where one value is allowed is told as one") {
  const std::string sweep =
      " is a range; one value is allowed here, several with --vary of "
      "`maquette sweep`: ";
  CHECK(error_of("1-8", WholeDimension::count) == "`1-8`" + sweep + "`1..8`");
  CHECK(error_of("1..8", WholeDimension::count) == "`1..8`" + sweep + "`1..8`");
  CHECK(error_of("1-8 MHz", RealDimension::frequency) == "`1-8 MHz`" + sweep + "`1..8 MHz`");
  CHECK(error_of("8 -", WholeDimension::count) ==
        "`8 -` has a unit; a plain number is allowed here");
}

TEST_CASE("what is no number, not whole or too large is refused") {
  for (const char* text :
       {"", " ", "nan", "inf", "-inf", "0x10", "e5", ".", "-", "--1", "1,5", "abc"}) {
    INFO(text);
    CHECK_FALSE(error_of(text, RealDimension::number).empty());
  }
  CHECK(error_of("0.1 ps", WholeDimension::time) ==
        "`0.1 ps` is not a whole number of ps of at most 18 places");
  CHECK(error_of("1.5", WholeDimension::count) ==
        "`1.5` is not a whole number of at most 18 places");
  for (const char* text :
       {"1e19 ps", "1e9 s", "99999999999999999999 ps", "1e-30 s", "1e999999999 s"}) {
    INFO(text);
    CHECK_FALSE(error_of(text, WholeDimension::time).empty());
  }
  CHECK_FALSE(error_of("1e400", RealDimension::number).empty());
  CHECK_FALSE(error_of("1e-400", RealDimension::number).empty());
}

TEST_CASE("quantities are written in the unit that makes them shortest") {
  CHECK(format_quantity(8e6, RealDimension::frequency) == "8 MHz");
  CHECK(format_quantity(14.75e6, RealDimension::frequency) == "14.75 MHz");
  CHECK(format_quantity(25.0, RealDimension::frequency) == "25 Hz");
  CHECK(format_quantity(0.25, RealDimension::number) == "0.25");
  CHECK(format_quantity(1e300, RealDimension::number) == "1e300");
  CHECK(format_quantity(std::int64_t{625'000}, WholeDimension::time) == "625 ns");
  CHECK(format_quantity(std::int64_t{400'000}, WholeDimension::time) == "400 ns");
  CHECK(format_quantity(std::int64_t{10'500'000}, WholeDimension::time) == "10.5 us");
  CHECK(format_quantity(std::int64_t{64'000'000}, WholeDimension::time) == "64 us");
  CHECK(format_quantity(std::int64_t{131072}, WholeDimension::memory) == "128 KiB");
  CHECK(format_quantity(std::int64_t{1000}, WholeDimension::memory) == "1000 B");
  CHECK(format_quantity(std::int64_t{1}, WholeDimension::clocks) == "1 clock");
  CHECK(format_quantity(std::int64_t{0}, WholeDimension::clocks) == "0 clocks");
}

TEST_CASE("whole quantities read back exactly") {
  std::mt19937_64 random{1};
  for (int i = 0; i < 20'000; ++i) {
    // All lengths of numbers alike.
    auto value = static_cast<std::int64_t>(random() >> (1 + random() % 63));
    value = random() % 2 == 0 ? value : -value;
    for (const WholeDimension dimension : k_whole_dimensions) {
      const std::string text = format_quantity(value, dimension);
      INFO(text);
      REQUIRE(parse_quantity(text, dimension) == value);
    }
  }
}

TEST_CASE("real quantities read back to the same bits") {
  std::mt19937_64 random{2};
  for (int i = 0; i < 20'000; ++i) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!(value >= -std::numeric_limits<double>::max() &&
          value <= std::numeric_limits<double>::max())) {
      continue;
    }
    for (const RealDimension dimension : k_real_dimensions) {
      const std::string text = format_quantity(value, dimension);
      INFO(text);
      const double back = parse_quantity(text, dimension);
      REQUIRE(std::memcmp(&back, &value, sizeof value) == 0);
    }
  }
}

TEST_CASE("the decimal point does not follow the locale") {
  // Without a locale that writes commas this shows nothing, and costs nothing.
  const char* locale = nullptr;
  for (const char* name : {"fr_FR.UTF-8", "fr_FR", "de_DE.UTF-8", "de_DE"}) {
    locale = locale == nullptr ? std::setlocale(LC_ALL, name) : locale;
  }
  CHECK(format_quantity(14.75e6, RealDimension::frequency) == "14.75 MHz");
  CHECK(parse_quantity("14.75 MHz", RealDimension::frequency) == 14.75e6);
  std::setlocale(LC_ALL, "C");
}

}  // namespace maquette::sim
