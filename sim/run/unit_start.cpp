#include "sim/run/unit_start.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sim/database/ram_layout.hpp"
#include "sim/database/unit_database.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {

namespace {

std::uint32_t reply_address(const MemoryMap& map) {
  const auto use = std::find_if(map.uses.begin(), map.uses.end(),
                                [](const MemoryUse& one) { return one.name == k_in_flight_use; });
  return static_cast<std::uint32_t>(use->address);
}

void check_room(const UnitDatabase& database, const char* kind, std::int64_t ram_bytes,
                const SourcePosition& position) {
  if (database.used_bytes > ram_bytes) {
    throw DescriptionError(
        position,
        fmt::format("the scene takes {} bytes of the RAM of each of the {} units, {} more than its "
                    "{}; raise units.{}.ram, or set board.allow_overflow=true to simulate it all "
                    "the same",
                    database.used_bytes, kind, database.used_bytes - ram_bytes, ram_bytes, kind));
  }
}

}  // namespace

void set_units(const Scene& scene, const PackedScene<float>& packed, const MemoryMap& map,
               Machine& machine, models::FrameSetup& setup) {
  models::UnitsParameters& units = machine.parameters.units;
  if (!models::has_units(units)) {
    return;
  }
  setup.reply_address = reply_address(map);
  const firmware::NumberFormat numbers = models::numbers_of(machine.parameters.board.arithmetic);
  for (std::size_t kind = 0; kind < units.kinds.size(); ++kind) {
    models::FunctionUnitParameters& unit = units.kinds[kind];
    if (unit.number == 0) {
      continue;
    }
    const UnitDatabase database =
        unit_database(static_cast<models::UnitKind>(kind), packed, numbers);
    if (!machine.allow_memory_overflow) {
      check_room(database, models::k_unit_kind_names[kind], unit.ram_bytes,
                 scene.object.position_in_file);
    }
    unit.ram_bytes = std::max(unit.ram_bytes, database.used_bytes);
    setup.unit_images.insert(setup.unit_images.end(), static_cast<std::size_t>(unit.number),
                             database.loaded);
  }
}

}  // namespace maquette::sim
