#pragma once

#include <cstdint>
#include <vector>

#include "sim/stability/stability_row.hpp"

namespace maquette::sim {

/// So many transfers on a saturated bus, of one master and of four in turn, without slaves and
/// kernel: its arbiter and its account, which keep all times. They end close to the longest
/// simulated time; every figure of the account is held against its closed form in integers.
[[nodiscard]] std::vector<StabilityRow> counted_transfer_rows(std::int64_t transfers);

}  // namespace maquette::sim
