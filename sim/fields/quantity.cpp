#include "sim/fields/quantity.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>

#include "sim/fields/decimal.hpp"

namespace maquette::sim {
namespace {

template <class Unit>
std::string list_units(const std::vector<Unit>& units) {
  std::string list;
  for (const Unit& unit : units) {
    list += (list.empty() ? "" : ", ") + (unit.name.empty() ? "none" : std::string{unit.name});
  }
  return list;
}

bool is_named(const RealUnit& unit, std::string_view name) { return unit.name == name; }

bool is_named(const WholeUnit& unit, std::string_view name) {
  return unit.name == name || (!unit.singular.empty() && unit.singular == name);
}

constexpr std::string_view k_range = "..";

/// What a text such as `1-8`, of which `-8` follows the number, means as a range: `1..8`. Empty
/// where it is none.
std::string meant_range(std::string_view text, std::string_view rest) {
  if (text.find(k_range) != std::string_view::npos) {
    return std::string{text};
  }
  const bool is_range = rest.size() > 1 && rest[0] == '-' && rest[1] >= '0' && rest[1] <= '9';
  return is_range ? std::string{text.substr(0, text.size() - rest.size())} + std::string{k_range} +
                        std::string{rest.substr(1)}
                  : "";
}

template <class Unit>
[[noreturn]] void fail_on_unit(std::string_view text, std::string_view name,
                               const std::vector<Unit>& units) {
  const std::string quoted = "`" + std::string{text} + "`";
  if (const std::string range = meant_range(text, name); !range.empty()) {
    throw std::invalid_argument(quoted + " is a range; one value is allowed here, several with " +
                                "--vary of `maquette sweep`: `" + range + "`");
  }
  if (units.size() == 1 && units.front().name.empty()) {
    throw std::invalid_argument(quoted + " has a unit; a plain number is allowed here");
  }
  const std::string list = "; allowed: " + list_units(units);
  if (name.empty()) {
    throw std::invalid_argument(quoted + " has no unit" + list);
  }
  throw std::invalid_argument(quoted + " has the unit `" + std::string{name} + "`" + list);
}

/// The number in `text`; leaves the unit's name in `text`.
Decimal take_number(std::string_view& text) {
  const std::string_view whole = text;
  const std::optional<Decimal> decimal = take_decimal(text);
  if (!decimal) {
    throw std::invalid_argument("`" + std::string{whole} + "` is not a number");
  }
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  return *decimal;
}

template <class Unit>
const Unit& find_unit(std::string_view text, std::string_view name,
                      const std::vector<Unit>& units) {
  const auto found = std::find_if(units.begin(), units.end(),
                                  [&](const Unit& unit) { return is_named(unit, name); });
  if (found == units.end()) {
    fail_on_unit(text, name, units);
  }
  return *found;
}

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit.empty() ? number : number + " " + std::string{unit};
}

/// Candidates come with growing units.
void keep_shorter(std::string& shortest, const std::string& candidate) {
  const bool is_odd = candidate.rfind("0.", 0) == 0 || candidate.find("e-") != std::string::npos;
  if (shortest.empty() || candidate.size() < shortest.size() ||
      (candidate.size() == shortest.size() && !is_odd)) {
    shortest = candidate;
  }
}

}  // namespace

double parse_quantity(std::string_view text, RealDimension dimension) {
  std::string_view name = text;
  Decimal decimal = take_number(name);
  decimal.exponent += find_unit(text, name, units(dimension)).decimal_exponent;
  const std::optional<double> value = to_double(decimal);
  if (!value) {
    throw std::invalid_argument("`" + std::string{text} +
                                "` is beyond the range of numbers, about 1e-308 to 1e308");
  }
  return *value;
}

std::int64_t parse_quantity(std::string_view text, WholeDimension dimension) {
  std::string_view name = text;
  const Decimal decimal = take_number(name);
  const std::vector<WholeUnit>& allowed = units(dimension);
  const std::optional<std::int64_t> value =
      to_whole(decimal, find_unit(text, name, allowed).factor);
  if (!value) {
    const std::string_view smallest = allowed.front().name;
    throw std::invalid_argument("`" + std::string{text} + "` is not a whole number" +
                                (smallest.empty() ? "" : " of " + std::string{smallest}) +
                                " of at most 18 places");
  }
  return *value;
}

std::string format_quantity(double value, RealDimension dimension) {
  std::string shortest;
  for (const RealUnit& unit : units(dimension)) {
    Decimal decimal = to_decimal(value);
    decimal.exponent -= decimal.digits.empty() ? 0 : unit.decimal_exponent;
    keep_shorter(shortest, with_unit(to_text(decimal), unit.name));
  }
  return shortest;
}

std::string format_quantity(std::int64_t value, WholeDimension dimension) {
  std::string shortest;
  for (const WholeUnit& unit : units(dimension)) {
    if (value % unit.factor == 0) {
      const bool singular = value == unit.factor && !unit.singular.empty();
      keep_shorter(shortest, with_unit(to_text(to_decimal(value / unit.factor)),
                                       singular ? unit.singular : unit.name));
    }
    // Powers of ten divide without loss: 10.5 us. Not so KiB, where 512 B is plainer anyway.
    Decimal decimal = to_decimal(value);
    if (is_decimal(dimension) && !decimal.digits.empty()) {
      decimal.exponent -= static_cast<int>(to_decimal(unit.factor).exponent);
      keep_shorter(shortest, with_unit(to_text(decimal), unit.name));
    }
  }
  return shortest;
}

std::string unit_list(RealDimension dimension) { return list_units(units(dimension)); }

std::string unit_list(WholeDimension dimension) { return list_units(units(dimension)); }

}  // namespace maquette::sim
