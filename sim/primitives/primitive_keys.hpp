#pragma once

#include <string_view>
#include <vector>

#include "sim/fields/key_table.hpp"
#include "sim/primitives/primitive_description.hpp"

namespace maquette::sim {

/// The keys of a shape, for which there is `declare(visitor, shape)`.
template <class Shape>
std::vector<KeyRow> listed_keys() {
  KeyTable table;
  Shape shape;
  declare(table, shape);
  return table.rows();
}

/// The keys of a primitive of the firmware's table, for people. Each has a specialisation in the
/// source of its name; without it the program does not link.
template <class Kind>
std::vector<KeyRow> keys_of();

/// Those of a description of the table.
[[nodiscard]] std::vector<KeyRow> keys_of(const PrimitiveDescription& primitive);

}  // namespace maquette::sim
