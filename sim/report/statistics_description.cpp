#include "sim/report/statistics_description.hpp"

#include <fmt/format.h>

#include <type_traits>
#include <vector>

#include "sim/report/statistics.hpp"

namespace maquette::sim {
namespace {

template <typename Value>
struct ElementOf {
  using Type = void;
};
template <typename Element>
struct ElementOf<std::vector<Element>> {
  using Type = Element;
};

template <typename Owner>
std::string describe_fields(const std::string& prefix);

template <typename Owner, typename Value>
std::string describe_field(const std::string& prefix, const Field<Owner, Value>& field) {
  using Element = typename ElementOf<Value>::Type;
  constexpr bool is_list_of_values = !std::is_void_v<Element> && !k_has_fields<Element>;
  using Group = typename GroupIfUsed<Value>::Type;
  const std::string key = prefix + field.name;
  std::string lines;
  if ((!k_has_fields<Value> && std::is_void_v<Group>) || *field.description != '\0') {
    lines = fmt::format("{:<36} {:<10} {}\n", key + (is_list_of_values ? "[]" : ""), field.unit,
                        field.description);
  }
  if constexpr (k_has_fields<Value>) {
    lines += describe_fields<Value>(key + ".");
  } else if constexpr (!std::is_void_v<Group>) {
    lines += describe_fields<Group>(key + ".");
  } else if constexpr (k_has_fields<Element>) {
    lines += describe_fields<Element>(key + "[].");
  }
  return lines;
}

template <typename Owner>
std::string describe_fields(const std::string& prefix) {
  std::string lines;
  for_each_field<Owner>(
      [&prefix, &lines](const auto& field) { lines += describe_field(prefix, field); });
  return lines;
}

}  // namespace

std::string describe_statistics() { return describe_fields<Statistics>(""); }

}  // namespace maquette::sim
