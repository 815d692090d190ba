#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {

/// A key that a description may have, for people.
struct KeyRow {
  std::string path;           ///< with the groups that it stands in
  std::string type;           ///< what values are allowed
  std::string default_value;  ///< empty: there is none
  bool required = false;
  std::string sentence;
};

namespace key_table {

template <class Type, class = void>
struct Told : std::false_type {};
template <class Type>
struct Told<Type, std::void_t<decltype(std::declval<const Type&>().range())>> : std::true_type {};

/// The range and the units of a type that tells them.
template <class Type>
std::string type_text(const Type& type) {
  if constexpr (Told<Type>::value) {
    const std::string unit = type.unit();
    const std::string range = type.range();
    return unit.empty() || unit == "none" ? range : range.empty() ? unit : range + "; " + unit;
  } else {
    return {};
  }
}

}  // namespace key_table

/// The visitor of declared fields that lists all keys, also those of groups that are not there.
class KeyTable {
 public:
  template <class Value, class Type>
  void field(const Declaration& declaration, const Value& value, const Type& type) {
    add(declaration, declaration.required ? std::string() : write_flow(type.write(value)), type);
  }

  template <class Value, class Type>
  void field(const Declaration& declaration, const std::optional<Value>& /*value*/,
             const Type& type) {
    add(declaration, {}, type);
  }

  template <class Body>
  void group(const Declaration& declaration, Body body) {
    rows_.push_back({prefix_ + std::string{declaration.key},
                     "a group of keys",
                     {},
                     declaration.required,
                     std::string{declaration.sentence}});
    const std::string before = prefix_;
    prefix_ += std::string{declaration.key} + ".";
    body();
    prefix_ = before;
  }

  template <class Body>
  void optional_group(const Declaration& declaration, const bool& /*present*/, Body body) {
    group(declaration, body);
  }

  [[nodiscard]] const std::vector<KeyRow>& rows() const { return rows_; }

 private:
  template <class Type>
  void add(const Declaration& declaration, std::string default_value, const Type& type) {
    rows_.push_back({prefix_ + std::string{declaration.key}, key_table::type_text(type),
                     std::move(default_value), declaration.required,
                     std::string{declaration.sentence}});
  }

  std::string prefix_;
  std::vector<KeyRow> rows_;
};

/// The keys as a list for people.
[[nodiscard]] std::string key_list(const std::vector<KeyRow>& rows);

}  // namespace maquette::sim
