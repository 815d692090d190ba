#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace maquette::sim {

/// A number with its unit as descriptions write them, whatever it measures.
struct Measure {
  double value = 0;
  std::string unit;  ///< "" for none; in the plural
};

/// Reads "8 MHz", "4 clocks", "12"; nothing for other texts.
[[nodiscard]] std::optional<Measure> read_measure(std::string_view text);

/// The text that read_measure reads back.
[[nodiscard]] std::string write_measure(const Measure& measure);

/// The value in another unit; nothing when the units measure different things.
[[nodiscard]] std::optional<double> value_in(const Measure& measure, const std::string& unit);

/// Whether values of this unit are whole numbers of the smallest unit of their kind.
[[nodiscard]] bool is_whole_unit(const std::string& unit);

/// The nearest measure that is a whole number of the smallest unit of its kind.
[[nodiscard]] Measure rounded_to_whole(const Measure& measure);

/// The nearest number of that many decimal digits: the same bytes whatever the host's mathematical
/// library does in its last place. `digits` is 1 to 17.
[[nodiscard]] double rounded_to_digits(double value, int digits);

}  // namespace maquette::sim
