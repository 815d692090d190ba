#pragma once

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/fields/declaration.hpp"
#include "sim/fields/value_types.hpp"
#include "sim/yaml/yaml_writer.hpp"

namespace maquette::sim {

/// One declared parameter for people. `path` is what `--set` takes.
struct ParameterRow {
  std::string path;
  std::string value;          ///< empty: nothing is said
  std::string unit;           ///< the allowed ones
  bool required = false;      ///< has no default
  std::string default_value;  ///< empty: it has none
  std::string range;
  std::string sentence;
  std::string source;
  bool is_whole = false;  ///< a whole number of its stored unit
};

/// The visitor of declared fields that lists them.
class ParameterTable {
 public:
  /// `prefix` is put before every path, e.g. "surfaces.gold."
  explicit ParameterTable(std::string prefix = {}) : prefixes_{std::move(prefix)} {}

  template <class Value, class Type>
  void field(const Declaration& declaration, const Value& value, const Type& type) {
    add(declaration, write_flow(type.write(value)), type);
  }

  template <class Value, class Type>
  void field(const Declaration& declaration, const std::optional<Value>& value, const Type& type) {
    add(declaration, value ? write_flow(type.write(*value)) : "", type);
  }

  template <class Body>
  void group(const Declaration& declaration, Body body) {
    prefixes_.push_back(prefixes_.back() + std::string{declaration.key} + ".");
    body();
    prefixes_.pop_back();
  }

  template <class Body>
  void optional_group(const Declaration& declaration, const bool& present, Body body) {
    if (present) {
      group(declaration, body);
    }
  }

  [[nodiscard]] const std::vector<ParameterRow>& rows() const { return rows_; }

 private:
  template <class Type>
  void add(const Declaration& declaration, const std::string& value, const Type& type) {
    rows_.push_back({prefixes_.back() + std::string{declaration.key},
                     value,
                     type.unit(),
                     declaration.required,
                     {},
                     type.range(),
                     std::string{declaration.sentence},
                     std::string{declaration.source},
                     std::is_same_v<Type, WholeType>});
  }

  std::vector<std::string> prefixes_;
  std::vector<ParameterRow> rows_;
};

/// Fills in the defaults of `rows` from a table of the same fields at their defaults.
[[nodiscard]] std::vector<ParameterRow> with_defaults(std::vector<ParameterRow> rows,
                                                      const std::vector<ParameterRow>& defaults);

}  // namespace maquette::sim
