#include "sim/primitives/primitive_keys.hpp"

#include <algorithm>

#include "sim/primitives/primitive_table.hpp"

namespace maquette::sim {

namespace {

using Keys = std::vector<KeyRow> (*)();

template <class... Kinds>
std::vector<Keys> keys_in(firmware::KindList<Kinds...> /*kinds*/) {
  return {&keys_of<Kinds>...};
}

}  // namespace

std::vector<KeyRow> keys_of(const PrimitiveDescription& primitive) {
  const auto& table = primitive_table();
  const auto place = std::find(table.begin(), table.end(), &primitive) - table.begin();
  return keys_in(firmware::Primitives{}).at(static_cast<std::size_t>(place))();
}

}  // namespace maquette::sim
