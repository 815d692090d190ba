#pragma once

#include <cstddef>
#include <vector>

#include "sim/trace/bus_record.hpp"

namespace maquette::sim {

/// What a board does: as a run's statistics have it, but that it is idle as well while it waits for
/// function units.
enum class BoardState { compute, wait_grant, transfer, idle };

/// In traces.
[[nodiscard]] const char* name_of(BoardState state);

/// One stay in a state.
struct StateInterval {
  BoardState state;
  models::Instant from;
  models::Instant to;
};

/// The states of a board: intervals, none of them empty, which tile the record's window without gap
/// or overlap. Assumption: a board has one access at a time, on whichever bus.
std::vector<StateInterval> board_states(const BusRecord& record, std::size_t board);

}  // namespace maquette::sim
