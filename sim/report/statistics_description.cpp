#include "sim/report/statistics_description.hpp"

#include <fmt/format.h>

#include "sim/report/statistics.hpp"

namespace maquette::sim {
namespace {

template <typename Element>
constexpr bool is_list(const std::vector<Element>* /*type*/) {
  return true;
}
constexpr bool is_list(const void* /*type*/) { return false; }

template <typename Owner>
std::string describe_fields(const std::string& prefix);

template <typename Owner, typename Value>
std::string describe_field(const std::string& prefix, const Field<Owner, Value>& field) {
  const std::string key = prefix + field.name;
  std::string lines;
  if (!k_has_fields<Value> || *field.description != '\0') {
    lines = fmt::format("{:<30} {:<10} {}\n", key, field.unit, field.description);
  }
  if constexpr (k_has_fields<Value>) {
    lines += describe_fields<Value>(key + ".");
  } else if constexpr (is_list(static_cast<const Value*>(nullptr))) {
    lines += describe_fields<typename Value::value_type>(key + "[].");
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
