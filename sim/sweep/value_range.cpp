#include "sim/sweep/value_range.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr std::string_view k_between = "..";
constexpr std::string_view k_logarithmic = "log ";
constexpr std::string_view k_count = " of ";
constexpr int k_digits = 6;
constexpr int k_step_digits = 12;

/// Distances from the end of a range that are taken for none, in steps.
constexpr double k_step_slack = 1e-9;

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(' ') - first + 1);
}

[[noreturn]] void fail(const YamlPlace& place, const std::string& message) {
  throw DescriptionError(place.position(), message);
}

std::string quoted(std::string_view text) { return "`" + std::string{text} + "`"; }

/// Reads the parts of one range; all messages name its text.
class RangeReader {
 public:
  RangeReader(std::string_view text, const YamlPlace& place) : text_(text), place_(place) {}

  [[nodiscard]] int count(std::string_view digits) const {
    int value = 0;
    const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (result.ec != std::errc{} || result.ptr != digits.data() + digits.size() || value < 2 ||
        value > k_most_values) {
      fail(place_, quoted(text_) + ": `of` needs a number of values from 2 to " +
                       std::to_string(k_most_values));
    }
    return value;
  }

  /// The value in `unit`; a value without a unit is taken to be in it.
  [[nodiscard]] double value(std::string_view part, const std::string& unit) const {
    const std::optional<Measure> measure = read_measure(part);
    const std::optional<double> value =
        !measure ? std::nullopt
                 : (measure->unit.empty() ? measure->value : value_in(*measure, unit));
    if (!value || !std::isfinite(*value)) {
      fail(place_, quoted(text_) + ": " + quoted(part) + " is not a number" +
                       (unit.empty() ? std::string{} : " of " + unit) +
                       "; allowed: FIRST..LAST, FIRST..LAST:STEP, FIRST..LAST of COUNT, "
                       "log FIRST..LAST of COUNT, with a unit after LAST");
    }
    return *value;
  }

  void check(const ValueRange& range) const {
    if (!(range.first < range.last)) {
      fail(place_, quoted(text_) + ": a range goes from the smaller to the larger value");
    }
    if (range.step && !(*range.step > 0)) {
      fail(place_, quoted(text_) + ": the step must be above 0");
    }
    if (range.step && (range.count || range.is_logarithmic)) {
      fail(place_, quoted(text_) + ": a step goes with neither a count nor `log`");
    }
    if (range.is_logarithmic && !(range.first > 0)) {
      fail(place_, quoted(text_) + ": `log` needs values above 0");
    }
  }

 private:
  std::string_view text_;
  const YamlPlace& place_;
};

/// The value at `share` of the way from the first to the last.
double between(const ValueRange& range, double share) {
  const double value = range.is_logarithmic
                           ? range.first * std::pow(range.last / range.first, share)
                           : range.first + share * (range.last - range.first);
  return std::clamp(rounded_to_digits(value, k_digits), range.first, range.last);
}

double step_of(const ValueRange& range) {
  const bool has_whole_ends =
      range.first == std::floor(range.first) && range.last == std::floor(range.last);
  if (!range.step && (range.is_logarithmic || !has_whole_ends)) {
    fail(range.place, "the range needs a number of values (`of 7`)" +
                          std::string{range.is_logarithmic ? "" : " or a step (`:0.1`)"});
  }
  return range.step.value_or(1);
}

std::vector<double> numbers_of(const ValueRange& range) {
  std::vector<double> numbers;
  if (range.count) {
    for (int i = 0; i < *range.count; ++i) {
      numbers.push_back(between(range, static_cast<double>(i) / (*range.count - 1)));
    }
    numbers.front() = range.first;
    numbers.back() = range.last;
    return numbers;
  }
  const double step = step_of(range);
  const double steps = std::floor((range.last - range.first) / step + k_step_slack);
  if (steps >= k_most_values) {
    fail(range.place, "the range has more than " + std::to_string(k_most_values) + " values");
  }
  for (int i = 0; i <= static_cast<int>(steps); ++i) {
    numbers.push_back(rounded_to_digits(range.first + i * step, k_step_digits));
  }
  return numbers;
}

}  // namespace

std::optional<ValueRange> read_range(const std::string& text, const YamlPlace& place) {
  std::string_view rest = trimmed(text);
  ValueRange range;
  range.place = place;
  if (rest.substr(0, k_logarithmic.size()) == k_logarithmic) {
    range.is_logarithmic = true;
    rest = trimmed(rest.substr(k_logarithmic.size()));
  }
  const std::size_t middle = rest.find(k_between);
  if (middle == std::string_view::npos || !read_measure(trimmed(rest.substr(0, middle)))) {
    return std::nullopt;
  }
  const RangeReader reader{text, place};
  const std::string_view first = trimmed(rest.substr(0, middle));
  rest.remove_prefix(middle + k_between.size());
  if (const std::size_t of = rest.find(k_count); of != std::string_view::npos) {
    range.count = reader.count(trimmed(rest.substr(of + k_count.size())));
    rest = rest.substr(0, of);
  }
  std::string_view step;
  if (const std::size_t colon = rest.find(':'); colon != std::string_view::npos) {
    step = trimmed(rest.substr(colon + 1));
    rest = rest.substr(0, colon);
  }
  const std::string_view last = trimmed(rest);
  range.unit = read_measure(last).value_or(Measure{}).unit;
  range.first = reader.value(first, range.unit);
  range.last = reader.value(last, range.unit);
  if (!step.empty()) {
    range.step = reader.value(step, range.unit);
  }
  reader.check(range);
  return range;
}

std::vector<Measure> values_of(const ValueRange& range, bool is_whole) {
  std::vector<Measure> values;
  for (const double number : numbers_of(range)) {
    const Measure exact{number, range.unit};
    const Measure value = is_whole ? rounded_to_whole(exact) : exact;
    if (values.empty() || values.back().value != value.value) {
      values.push_back(value);
    }
  }
  return values;
}

Measure value_at(const ValueRange& range, bool is_whole, double share) {
  const bool has_few_values =
      is_whole && !range.is_logarithmic && range.first == std::floor(range.first) &&
      range.last == std::floor(range.last) && rounded_to_whole({0.5, range.unit}).value != 0.5;
  if (has_few_values) {
    const double number = range.first + std::floor(share * (range.last - range.first + 1));
    return {std::min(number, range.last), range.unit};
  }
  const Measure value{between(range, share), range.unit};
  return is_whole ? rounded_to_whole(value) : value;
}

}  // namespace maquette::sim
