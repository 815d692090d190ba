#include "sim/report/scalar_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "models/bus/wide.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

template <typename Value>
inline constexpr bool k_is_number = std::is_same_v<Value, models::Duration> ||
                                    (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>);

std::string text_of(models::Duration value) { return format_seconds(value); }
std::string text_of(const std::string& value) { return value; }

template <typename Value>
std::enable_if_t<std::is_arithmetic_v<Value>, std::string> text_of(Value value) {
  return fmt::format("{}", value);
}

/// What adds up a list's numbers: the sum of times and counts may have more than their 64 bits.
template <typename Number>
using Sum = std::conditional_t<std::is_floating_point_v<Number>, double, models::Wide>;

void add(models::Duration value, models::Wide& sum) { sum += value.count(); }

template <typename Number, typename Total>
std::enable_if_t<std::is_arithmetic_v<Number>> add(Number value, Total& sum) {
  sum += value;
}

/// Times to the nearest picosecond, ties away from zero.
template <typename Number, typename Total>
auto mean_of(Total sum, std::size_t count) {
  if constexpr (std::is_same_v<Number, models::Duration>) {
    const auto parts = static_cast<models::Wide>(count);
    return models::Duration(static_cast<models::Duration::rep>((sum + parts / 2) / parts));
  } else {
    return static_cast<double>(sum) / static_cast<double>(count);
  }
}

class Lister {
 public:
  std::vector<ScalarStatistic> scalars;

  template <typename Group>
  void list_group(const std::string& prefix, const Group& group) {
    for_each_field<Group>([&](const auto& field) {
      this->list({prefix + field.name, field.description, field.unit, ""}, group.*field.member);
    });
  }

 private:
  void add(const ScalarStatistic& declared, const std::string& suffix, std::string text) {
    scalars.push_back({declared.name + suffix, declared.sentence, declared.unit, std::move(text)});
  }

  template <typename Value>
  void list(const ScalarStatistic& declared, const Value& value) {
    if constexpr (k_has_fields<Value>) {
      list_group(declared.name + ".", value);
    } else {
      add(declared, "", text_of(value));
    }
  }

  template <typename Group>
  void list(const ScalarStatistic& declared, const std::optional<Group>& group) {
    const std::size_t first = scalars.size();
    list(declared, group.value_or(Group{}));
    for (std::size_t i = first; !group && i < scalars.size(); ++i) {
      scalars[i].text.clear();
    }
  }

  template <typename Number>
  void list(const ScalarStatistic& declared, const PerOperation<Number>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      add(declared, std::string{"."} + firmware::k_operation_names[i], text_of(numbers[i]));
    }
  }

  void list(const ScalarStatistic& declared, const FunctionTimes& times) {
    for (std::size_t i = 0; i < times.values.size(); ++i) {
      add(declared, "." + function_name(static_cast<int>(i)), text_of(times.values[i]));
    }
  }

  template <typename Element>
  void list(const ScalarStatistic& declared, const std::vector<Element>& elements) {
    if constexpr (k_has_fields<Element>) {
      for_each_field<Element>([&](const auto& field) {
        this->list_over({declared.name + "." + field.name, field.description, field.unit, ""},
                        elements, field.member);
      });
    }
  }

  template <typename Element, typename Value>
  void list_over(const ScalarStatistic& declared, const std::vector<Element>& elements,
                 Value Element::*member) {
    if constexpr (k_is_number<Value>) {
      std::string least;
      std::string mean;
      std::string greatest;
      if (!elements.empty()) {
        Sum<Value> sum{};
        const auto by_member = [member](const Element& first, const Element& second) {
          return first.*member < second.*member;
        };
        for (const Element& element : elements) {
          sim::add(element.*member, sum);
        }
        const auto [first, last] = std::minmax_element(elements.begin(), elements.end(), by_member);
        least = text_of((*first).*member);
        mean = text_of(mean_of<Value>(sum, elements.size()));
        greatest = text_of((*last).*member);
      }
      add(declared, ".min", least);
      add(declared, ".mean", mean);
      add(declared, ".max", greatest);
    }
  }
};

}  // namespace

std::vector<ScalarStatistic> scalar_statistics(const Statistics& statistics) {
  Lister lister;
  lister.list_group("", statistics);
  return lister.scalars;
}

}  // namespace maquette::sim
