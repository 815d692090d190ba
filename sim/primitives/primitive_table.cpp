#include "sim/primitives/primitive_table.hpp"

#include <algorithm>

namespace maquette::sim {
namespace {

using Table = std::array<const PrimitiveDescription*, firmware::k_primitive_kind_count>;

template <class... Kinds>
Table table_of(firmware::KindList<Kinds...> /*kinds*/) {
  return {&description_of<Kinds>()...};
}

}  // namespace

const Table& primitive_table() {
  static const Table table = table_of(firmware::Primitives{});
  return table;
}

const PrimitiveDescription& description_of(firmware::PrimitiveKind kind) {
  return *primitive_table().at(static_cast<std::size_t>(kind));
}

const PrimitiveDescription* find_primitive(std::string_view name) {
  const Table& table = primitive_table();
  const auto* const found =
      std::find_if(table.begin(), table.end(),
                   [name](const PrimitiveDescription* each) { return each->name == name; });
  return found == table.end() ? nullptr : *found;
}

}  // namespace maquette::sim
