#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "sim/fields/decimal.hpp"
#include "sim/fields/quantity.hpp"
#include "sim/report/seconds.hpp"
#include "sim/sweep/axis.hpp"
#include "sim/sweep/measure.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/override.hpp"
#include "tests/fuzz/harness.hpp"

namespace maquette::fuzz {

namespace {

using sim::RealDimension;
using sim::WholeDimension;

constexpr std::array<RealDimension, 4> k_reals{RealDimension::number, RealDimension::fraction,
                                               RealDimension::frequency, RealDimension::angle};
constexpr std::array<WholeDimension, 7> k_wholes{
    WholeDimension::count, WholeDimension::time,   WholeDimension::memory, WholeDimension::clocks,
    WholeDimension::bits,  WholeDimension::pixels, WholeDimension::lines};

/// A quantity that was read is the same when it is written and read again.
template <typename Dimension>
void hold_quantity(const std::string& text, Dimension dimension) {
  try {
    const auto value = sim::parse_quantity(text, dimension);
    const std::string written = sim::format_quantity(value, dimension);
    try {
      require(sim::parse_quantity(written, dimension) == value,
              "a quantity is another one when it is read again: " + written);
    } catch (const std::invalid_argument& error) {
      throw BrokenLaw("a quantity that was written is refused: " + written);
    }
  } catch (const std::invalid_argument&) {
    return;
  }
}

void hold_decimal(std::string_view text) {
  const std::optional<sim::Decimal> decimal = sim::take_decimal(text);
  if (!decimal) {
    return;
  }
  const std::optional<double> value = sim::to_double(*decimal);
  require(!value || std::isfinite(*value), "a decimal became no number");
  for (const std::int64_t factor : {std::int64_t{1}, std::int64_t{1'000'000'000'000}}) {
    static_cast<void>(sim::to_whole(*decimal, factor));
  }
  if (value) {
    const std::optional<double> again = sim::to_double(sim::to_decimal(*value));
    require(again == value, "a number is another one when it is read again");
  }
}

void hold_measure(std::string_view text) {
  const std::optional<sim::Measure> measure = sim::read_measure(text);
  if (!measure) {
    return;
  }
  const std::optional<sim::Measure> again = sim::read_measure(sim::write_measure(*measure));
  require(again && again->value == measure->value && again->unit == measure->unit,
          "a measure is another one when it is read again");
  static_cast<void>(sim::rounded_to_whole(*measure));
  for (const int digits : {1, 6, 17}) {
    static_cast<void>(sim::rounded_to_digits(measure->value, digits));
  }
}

void hold_seconds(std::string_view text) {
  if (const auto duration = sim::parse_seconds(text)) {
    require(sim::parse_seconds(sim::format_seconds(*duration)) == duration,
            "a duration is another one when it is read again");
    static_cast<void>(sim::readable_duration(*duration));
  }
}

template <typename Read>
void read_option(Read read) {
  try {
    static_cast<void>(read());
  } catch (const sim::DescriptionError&) {
    return;
  }
}

}  // namespace

void try_values(const std::string& input) {
  for (const RealDimension dimension : k_reals) {
    hold_quantity(input, dimension);
  }
  for (const WholeDimension dimension : k_wholes) {
    hold_quantity(input, dimension);
  }
  hold_decimal(input);
  hold_measure(input);
  hold_seconds(input);
  if (input.find('=') != std::string::npos) {
    read_option([&input] { return sim::parse_override(input); });
    read_option([&input] { return sim::parse_axis(input); });
  }
}

std::vector<std::string> values_seeds() {
  return {"8 MHz",
          "62.5 ns",
          "1.475e7 Hz",
          "16 MiB",
          "4 clocks",
          "1 clock",
          "33.3 %",
          "0.1 us",
          "106.75",
          "9223372.036854775807",
          "9223372036854775807 ps",
          "-9223372036854775808",
          "4.9406564584124654e-324",
          "1.7976931348623157e308",
          "30 deg",
          "768 pixels",
          "625 lines",
          "24 bits",
          "processors=1..64:8",
          "bus.clock=log 1..1000 kHz of 12",
          "bus.clock=8..16 MHz:2,32 MHz",
          "object.union.0.place=[{scale: 2}, {translate: [1, 2, 3]}]"};
}

}  // namespace maquette::fuzz
