#include "sim/sweep/measure.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "sim/fields/decimal.hpp"
#include "sim/fields/dimension.hpp"

namespace maquette::sim {
namespace {

/// A unit of any kind: `factor` times the smallest or the base unit of its kind.
struct AnyUnit {
  std::string_view name;
  std::string_view singular;
  double factor;
  bool is_whole;
  std::size_t kind;
};

std::vector<AnyUnit> list_units() {
  constexpr std::array k_real{RealDimension::number, RealDimension::fraction,
                              RealDimension::frequency, RealDimension::angle};
  constexpr std::array k_whole{WholeDimension::time, WholeDimension::memory, WholeDimension::clocks,
                               WholeDimension::bits, WholeDimension::pixels, WholeDimension::lines};
  std::vector<AnyUnit> list;
  std::size_t kind = 0;
  for (const RealDimension dimension : k_real) {
    for (const RealUnit& unit : units(dimension)) {
      list.push_back({unit.name, "", std::pow(10.0, unit.decimal_exponent), false, kind});
    }
    ++kind;
  }
  for (const WholeDimension dimension : k_whole) {
    for (const WholeUnit& unit : units(dimension)) {
      list.push_back({unit.name, unit.singular, static_cast<double>(unit.factor), true, kind});
    }
    ++kind;
  }
  return list;
}

/// The unit of this name; the plain number for "". Null when there is none.
const AnyUnit* find_unit(std::string_view name) {
  static const std::vector<AnyUnit> list = list_units();
  for (const AnyUnit& unit : list) {
    if (unit.name == name || (!unit.singular.empty() && unit.singular == name)) {
      return &unit;
    }
  }
  return nullptr;
}

}  // namespace

std::optional<Measure> read_measure(std::string_view text) {
  const std::optional<Decimal> number = take_decimal(text);
  if (!number) {
    return std::nullopt;
  }
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const AnyUnit* unit = find_unit(text);
  const std::optional<double> value = to_double(*number);
  if (unit == nullptr || !value) {
    return std::nullopt;
  }
  return Measure{*value, std::string{unit->name}};
}

std::string write_measure(const Measure& measure) {
  const std::string number = to_text(to_decimal(measure.value));
  return measure.unit.empty() ? number : number + " " + measure.unit;
}

std::optional<double> value_in(const Measure& measure, const std::string& unit) {
  const AnyUnit* from = find_unit(measure.unit);
  const AnyUnit* to = find_unit(unit);
  if (from == nullptr || to == nullptr || from->kind != to->kind) {
    return std::nullopt;
  }
  return from == to ? measure.value : measure.value * from->factor / to->factor;
}

bool is_whole_unit(const std::string& unit) {
  const AnyUnit* found = find_unit(unit);
  return found != nullptr && found->is_whole;
}

Measure rounded_to_whole(const Measure& measure) {
  const AnyUnit* unit = find_unit(measure.unit);
  const double factor = unit == nullptr ? 1 : unit->factor;
  return {std::round(measure.value * factor) / factor, measure.unit};
}

double rounded_to_digits(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  std::string_view rest = text;
  return to_double(take_decimal(rest).value_or(Decimal{})).value_or(0);
}

}  // namespace maquette::sim
