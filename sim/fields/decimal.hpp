#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace maquette::sim {

/// An exact decimal number: digits * 10^exponent. The digits have no leading and no trailing zeros;
/// zero has none.
struct Decimal {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

/// Reads "12", "-0.5", "1.475e7"... from the start of `text` and shortens `text` to what follows
/// it. Nothing when there is no number (also for "nan", "inf", hexadecimal) or its exponent is
/// beyond a million.
[[nodiscard]] std::optional<Decimal> take_decimal(std::string_view& text);

/// The shortest decimal that reads back to the same number.
[[nodiscard]] Decimal to_decimal(double value);
[[nodiscard]] Decimal to_decimal(std::int64_t value);

/// The nearest number; nothing when it is too large, or too small to be told from zero.
[[nodiscard]] std::optional<double> to_double(const Decimal& decimal);

/// decimal * factor when that is a whole number that fits 64 bits; nothing otherwise. `factor` > 0.
[[nodiscard]] std::optional<std::int64_t> to_whole(const Decimal& decimal, std::int64_t factor);

/// As people write it: plain up to 15 places, with an exponent beyond.
[[nodiscard]] std::string to_text(const Decimal& decimal);

}  // namespace maquette::sim
