#pragma once

#include <cstddef>
#include <vector>

#include "sim/trace/bus_record.hpp"
#include "sim/trace/vcd_changes.hpp"
#include "sim/trace/vcd_dump.hpp"

namespace maquette::sim {

/// Adds a scope of a backplane, as write_vcd_trace says, and what tells of its accesses. Keeps all
/// by reference.
std::vector<ChangeSource> dump_bus(const BusRecord& record, const RecordedBus& bus, VcdDump& dump);

/// Adds a scope of a board, or of a function unit, likewise.
ChangeSource dump_board(const BusRecord& record, std::size_t board, VcdDump& dump);

}  // namespace maquette::sim
