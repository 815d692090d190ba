#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <tuple>
#include <type_traits>

#include "firmware/arithmetic/work.hpp"

namespace maquette::sim {

/// The one declaration of a statistic: key in stats.json (times end in _s), unit, meaning, place.
/// Writer, reader and documentation walk these declarations and know no statistic by name.
template <typename Owner, typename Value>
struct Field {
  const char* name;
  const char* unit;  ///< "s", "pixels", "1" for a ratio, "" for a text or a group
  const char* description;
  Value Owner::*member;
};

template <typename Owner, typename Value>
constexpr Field<Owner, Value> field(const char* name, const char* unit, const char* description,
                                    Value Owner::*member) {
  return {name, unit, description, member};
}

/// Whether a type declares fields of its own.
template <typename Type, typename = void>
inline constexpr bool k_has_fields = false;
template <typename Type>
inline constexpr bool k_has_fields<Type, std::void_t<decltype(Type::fields())>> = true;

/// What an optional group holds; void of what is none.
template <typename Value>
struct GroupIfUsed {
  using Type = void;
};
template <typename Group>
struct GroupIfUsed<std::optional<Group>> {
  using Type = Group;
};

/// Calls `action` with each field of `Owner`, in the order of their declaration.
template <typename Owner, typename Action>
void for_each_field(Action&& action) {
  std::apply([&action](const auto&... fields) { (action(fields), ...); }, Owner::fields());
}

/// A number per operation class, keyed by firmware::k_operation_names.
template <typename Number>
using PerOperation = std::array<Number, firmware::k_operation_count>;
using OperationCounts = PerOperation<std::uint64_t>;
using OperationClocks = PerOperation<double>;

}  // namespace maquette::sim
