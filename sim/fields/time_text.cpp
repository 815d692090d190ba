#include "sim/fields/time_text.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "sim/fields/decimal.hpp"
#include "sim/fields/quantity.hpp"

namespace maquette::sim {

namespace {

constexpr std::int64_t k_ticks_per_minute = 60'000'000'000'000;

struct LongUnit {
  std::string_view name;
  std::int64_t ticks;
};

constexpr LongUnit k_long_units[] = {{"h", 60 * k_ticks_per_minute}, {"min", k_ticks_per_minute}};

std::string_view without_spaces(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return text;
}

/// Takes a number of this unit from the beginning of a text, if it begins with one.
std::optional<std::int64_t> take(const LongUnit& unit, std::string_view& text) {
  std::string_view rest = text;
  const std::optional<Decimal> number = take_decimal(rest);
  rest = without_spaces(rest);
  if (!number || rest.substr(0, unit.name.size()) != unit.name) {
    return std::nullopt;
  }
  const std::string_view behind = rest.substr(unit.name.size());
  if (!behind.empty() && behind.front() != ' ') {
    return std::nullopt;
  }
  const std::optional<std::int64_t> ticks = to_whole(*number, unit.ticks);
  if (ticks) {
    text = without_spaces(behind);
  }
  return ticks;
}

}  // namespace

std::int64_t parse_time(std::string_view text) {
  std::string_view rest = without_spaces(text);
  std::int64_t sum = 0;
  bool is_long = false;
  for (const LongUnit& unit : k_long_units) {
    if (const std::optional<std::int64_t> ticks = take(unit, rest)) {
      sum += *ticks;
      is_long = true;
    }
  }
  if (is_long && rest.empty()) {
    return sum;
  }
  try {
    const std::int64_t ticks = parse_quantity(rest, WholeDimension::time);
    if (is_long && (ticks < 0 || sum < 0)) {
      throw std::invalid_argument("`" + std::string(text) + "` has a sign within");
    }
    return sum + ticks;
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(error.what()) +
                                ", and min and h before them, as in \"6 min 59 s\"");
  }
}

}  // namespace maquette::sim
