#pragma once

#include <array>
#include <string_view>

#include "firmware/primitives/primitive_table.hpp"
#include "sim/primitives/primitive_description.hpp"

namespace maquette::sim {

/// The primitives of the firmware's table, in its order.
[[nodiscard]] const std::array<const PrimitiveDescription*, firmware::k_primitive_kind_count>&
primitive_table();

[[nodiscard]] const PrimitiveDescription& description_of(firmware::PrimitiveKind kind);

/// A null pointer when no primitive has that name.
[[nodiscard]] const PrimitiveDescription* find_primitive(std::string_view name);

}  // namespace maquette::sim
