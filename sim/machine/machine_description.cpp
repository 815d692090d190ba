#include "sim/machine/machine_description.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "sim/fields/field_reader.hpp"
#include "sim/fields/field_writer.hpp"
#include "sim/fields/key_list.hpp"
#include "sim/machine/machine_checks.hpp"
#include "sim/machine/machine_fields.hpp"

namespace maquette::sim {

Machine default_machine() {
  Machine machine;
  machine.parameters.boards = to_place_list(BoardPlaces{});
  return machine;
}

Machine read_machine(const YamlNode& root) {
  Machine machine = default_machine();
  FieldReader reader{root, "machine"};
  declare_machine(reader, machine);
  reader.finish();
  check_machine(machine, root);
  return machine;
}

YamlNode write_machine(Machine machine) {
  FieldWriter writer;
  declare_machine(writer, machine);
  return writer.take();
}

std::vector<ParameterRow> list_parameters(Machine machine) {
  ParameterTable table;
  declare_machine(table, machine);
  ParameterTable defaults;
  Machine standard = default_machine();
  for (std::size_t kind = 0; kind < machine.parameters.units.kinds.size(); ++kind) {
    standard.parameters.units.kinds[kind].number =
        std::min(machine.parameters.units.kinds[kind].number, 1);  // a kind that is there has one
  }
  declare_machine(defaults, standard);
  return with_defaults(table.rows(), defaults.rows());
}

std::vector<std::string_view> machine_keys() {
  KeyList list;
  Machine machine = default_machine();
  declare_machine(list, machine);
  return list.keys();
}

}  // namespace maquette::sim
