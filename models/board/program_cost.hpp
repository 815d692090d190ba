#pragma once

#include <cstdint>

#include "models/board/kvm02_parameters.hpp"
#include "models/board/mc68000/account.hpp"

namespace maquette::models {

/// Thousandths of a clock that a program has taken so far: its cycles and the wait states of the
/// board's RAM, without its accesses off the board, which the bus times, and before refresh.
std::int64_t program_milliclocks(const mc68000::Account& account, const Kvm02Parameters& board);

}  // namespace maquette::models
