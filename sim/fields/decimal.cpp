#include "sim/fields/decimal.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <limits>
#include <numeric>
#include <system_error>
#include <utility>

namespace maquette::sim {
namespace {

constexpr int k_largest_exponent = 1'000'000;

std::string_view take_digits(std::string_view& text) {
  const std::size_t end = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  return digits;
}

bool take_character(std::string_view& text, std::string_view characters) {
  if (text.empty() || characters.find(text.front()) == std::string_view::npos) {
    return false;
  }
  text.remove_prefix(1);
  return true;
}

/// The exponent after "e"; leaves `text` alone when there is none, as in "8 eV".
std::optional<int> take_exponent(std::string_view& text) {
  std::string_view rest = text;
  if (!take_character(rest, "eE")) {
    return 0;
  }
  const bool negative = rest.substr(0, 1) == "-";
  take_character(rest, "+-");
  const std::string_view digits = take_digits(rest);
  if (digits.empty()) {
    return 0;
  }
  int exponent = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  if (result.ec != std::errc{} || exponent > k_largest_exponent) {
    return std::nullopt;
  }
  text = rest;
  return negative ? -exponent : exponent;
}

/// Strips the zeros at both ends.
Decimal normalized(bool negative, std::string digits, int exponent) {
  digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size()));
  while (!digits.empty() && digits.back() == '0') {
    digits.pop_back();
    ++exponent;
  }
  if (digits.empty()) {
    exponent = 0;
  }
  return {negative, std::move(digits), exponent};
}

}  // namespace

std::optional<Decimal> take_decimal(std::string_view& text) {
  std::string_view rest = text;
  const bool negative = rest.substr(0, 1) == "-";
  take_character(rest, "+-");
  std::string digits{take_digits(rest)};
  int exponent = 0;
  if (take_character(rest, ".")) {
    const std::string_view fraction = take_digits(rest);
    if (fraction.size() > k_largest_exponent) {
      return std::nullopt;
    }
    digits += fraction;
    exponent = -static_cast<int>(fraction.size());
  }
  if (digits.empty() || digits.size() > k_largest_exponent) {
    return std::nullopt;
  }
  const std::optional<int> power = take_exponent(rest);
  if (!power) {
    return std::nullopt;
  }
  text = rest;
  return normalized(negative, std::move(digits), exponent + *power);
}

Decimal to_decimal(double value) {
  std::array<char, 32> buffer{};
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                 std::chars_format::scientific);
  std::string_view text{buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data())};
  return take_decimal(text).value_or(Decimal{});
}

Decimal to_decimal(std::int64_t value) {
  const std::string text = std::to_string(value);
  std::string_view rest = text;
  return take_decimal(rest).value_or(Decimal{});
}

std::optional<double> to_double(const Decimal& decimal) {
  if (decimal.digits.empty()) {
    return decimal.negative ? -0.0 : 0.0;
  }
  const std::string text =
      (decimal.negative ? "-" : "") + decimal.digits + "e" + std::to_string(decimal.exponent);
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc{}) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> to_whole(const Decimal& decimal, std::int64_t factor) {
  if (decimal.digits.empty()) {
    return 0;
  }
  constexpr int k_places = std::numeric_limits<std::int64_t>::digits10;
  if (std::abs(decimal.exponent) > k_places) {
    return std::nullopt;
  }
  std::int64_t whole = 0;
  const auto result =
      std::from_chars(decimal.digits.data(), decimal.digits.data() + decimal.digits.size(), whole);
  if (result.ec != std::errc{}) {
    return std::nullopt;
  }
  std::int64_t divisor = 1;
  for (int i = decimal.exponent; i < 0; ++i) {
    divisor *= 10;
  }
  const std::int64_t common = std::gcd(factor, divisor);
  factor /= common;
  divisor /= common;
  if (whole % divisor != 0) {
    return std::nullopt;
  }
  whole /= divisor;
  constexpr std::int64_t k_largest = std::numeric_limits<std::int64_t>::max();
  for (int i = 0; i < decimal.exponent; ++i) {
    if (whole > k_largest / 10) {
      return std::nullopt;
    }
    whole *= 10;
  }
  if (whole > k_largest / factor) {
    return std::nullopt;
  }
  return decimal.negative ? -whole * factor : whole * factor;
}

std::string to_text(const Decimal& decimal) {
  constexpr int k_plain_places = 15;
  constexpr int k_leading_zeros = 3;
  const std::string sign = decimal.negative ? "-" : "";
  const std::string& digits = decimal.digits;
  const int point = static_cast<int>(digits.size()) + decimal.exponent;  // digits before the point
  if (digits.empty()) {
    return sign + "0";
  }
  if (decimal.exponent >= 0 && point <= k_plain_places) {
    return sign + digits + std::string(static_cast<std::size_t>(decimal.exponent), '0');
  }
  if (decimal.exponent < 0 && point > 0) {
    return sign + digits.substr(0, static_cast<std::size_t>(point)) + "." +
           digits.substr(static_cast<std::size_t>(point));
  }
  if (decimal.exponent < 0 && point >= -k_leading_zeros) {
    return sign + "0." + std::string(static_cast<std::size_t>(-point), '0') + digits;
  }
  const std::string fraction = digits.size() > 1 ? "." + digits.substr(1) : "";
  return sign + digits.substr(0, 1) + fraction + "e" + std::to_string(point - 1);
}

}  // namespace maquette::sim
