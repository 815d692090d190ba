#pragma once

#include <vector>

#include "sim/fields/parameter_table.hpp"
#include "sim/machine/machine.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// Every parameter at its declared default; the cost table, which has none, is empty.
[[nodiscard]] Machine default_machine();

/// Reads a machine whose cost table stands inline under board.arithmetic. Throws DescriptionError.
[[nodiscard]] Machine read_machine(const YamlNode& root);

/// The whole machine with every value, its cost table inline.
[[nodiscard]] YamlNode write_machine(Machine machine);

/// Every parameter of the machine for people.
[[nodiscard]] std::vector<ParameterRow> list_parameters(Machine machine);

/// The keys at the top of a machine description.
[[nodiscard]] std::vector<std::string_view> machine_keys();

}  // namespace maquette::sim
