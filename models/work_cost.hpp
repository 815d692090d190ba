#pragma once

#include <array>
#include <cstdint>

#include "firmware/work.hpp"
#include "models/machine_parameters.hpp"
#include "models/period.hpp"

namespace maquette::models {

/// How long a board needs for a Work.
///
/// An operation costs its clocks, the RAM's wait clocks for each of its reads and writes, and the
/// same of the call overhead when it is a call of the arithmetic package; rounded once to a
/// thousandth of a clock. Refresh steals refresh_clocks from every refresh_period of elapsed time,
/// wherever they fall, so the elapsed time is the processor's divided by (1 - their share).
class WorkCost {
 public:
  /// Throws std::invalid_argument for a negative cost or a refresh that leaves no time.
  explicit WorkCost(const Kvm02Parameters& board);

  /// Elapsed time of `work`: the processor's, then the elapsed, each rounded down to the
  /// picosecond.
  [[nodiscard]] Duration duration(const firmware::Work& work) const;

  /// Cost of one operation in thousandths of a clock, before refresh.
  [[nodiscard]] std::int64_t milliclocks(firmware::Operation operation) const {
    return milliclocks_[static_cast<std::size_t>(operation)];
  }

 private:
  std::array<std::int64_t, firmware::k_operation_count> milliclocks_{};
  Period milliclock_;
  Period elapsed_per_processor_ps_;
};

}  // namespace maquette::models
