#pragma once

#include <optional>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/report/statistics.hpp"

namespace maquette::tests {

inline void randomise(std::mt19937_64& random, std::string& value) {
  value = "name \"" + std::to_string(random() % 1000) + "\\\n";
}
inline void randomise(std::mt19937_64& random, bool& value) { value = random() % 2 == 0; }
inline void randomise(std::mt19937_64& random, models::Duration& value) {
  value = models::Duration(static_cast<std::int64_t>(random() >> (1 + random() % 63)));
}
inline void randomise(std::mt19937_64& random, double& value) {
  value = static_cast<double>(random()) / static_cast<double>(1 + (random() >> (random() % 63)));
}
template <typename Integer>
std::enable_if_t<std::is_integral_v<Integer>> randomise(std::mt19937_64& random, Integer& value) {
  value = static_cast<Integer>(random());
}
template <typename Number>
void randomise(std::mt19937_64& random, sim::PerOperation<Number>& numbers) {
  for (Number& number : numbers) {
    number = static_cast<Number>(random() >> (random() % 64));
  }
}
inline void randomise(std::mt19937_64& random, sim::FunctionTimes& times) {
  for (models::Duration& time : times.values) {
    randomise(random, time);
  }
}
template <typename Group>
std::enable_if_t<sim::k_has_fields<Group>> randomise(std::mt19937_64& random, Group& group);

template <typename Element>
void randomise(std::mt19937_64& random, std::vector<Element>& elements) {
  elements.resize(random() % 5);
  for (auto& element : elements) {
    randomise(random, element);
  }
}
template <typename Group>
void randomise(std::mt19937_64& random, std::optional<Group>& group) {
  group.reset();
  if (random() % 2 == 0) {
    randomise(random, group.emplace());
  }
}
template <typename Group>
std::enable_if_t<sim::k_has_fields<Group>> randomise(std::mt19937_64& random, Group& group) {
  sim::for_each_field<Group>(
      [&random, &group](const auto& field) { randomise(random, group.*field.member); });
}

/// Statistics with a random value in every field that is declared.
inline sim::Statistics random_statistics(std::mt19937_64& random) {
  sim::Statistics statistics;
  randomise(random, statistics);
  return statistics;
}

}  // namespace maquette::tests
