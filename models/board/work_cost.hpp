#pragma once

#include <array>
#include <cstdint>

#include "firmware/arithmetic/work.hpp"
#include "models/board/kvm02_parameters.hpp"
#include "models/bus/period.hpp"

namespace maquette::models {

/// How long a board needs for a Work.
///
/// An operation costs its clocks, the RAM's wait clocks for each of its reads and writes, and the
/// same of the call overhead when it is a call of the arithmetic package; rounded once to a
/// thousandth of a clock. Refresh steals refresh_clocks from every refresh_period of elapsed time,
/// wherever they fall, so the elapsed time is the processor's divided by (1 - their share).
///
/// A load from a shared database is an instruction that the board fetches from its RAM, at the cost
/// of a load less database_read with its wait states, and bus accesses for the datum, which the bus
/// times. So nothing is paid twice.
class WorkCost {
 public:
  /// Throws std::invalid_argument for a negative cost, also of a load without its datum when the
  /// database is shared, or a refresh that leaves no time.
  explicit WorkCost(const Kvm02Parameters& board);

  /// Elapsed time of `work`, of whose loads `bus_loads` get their datum over the bus (that time not
  /// included): the processor's, then the elapsed, each rounded down to the picosecond;
  /// Duration::max() when it is longer.
  [[nodiscard]] Duration duration(const firmware::Work& work, std::int64_t bus_loads = 0) const;

  /// Elapsed time of so many thousandths of the processor's clocks, rounded as above.
  [[nodiscard]] Duration elapsed(std::int64_t milliclocks) const {
    return elapsed_per_processor_ps_.times(milliclock_.times(milliclocks).count());
  }

  /// Thousandths of a clock that `work` takes, before refresh; the largest number when it is
  /// larger.
  [[nodiscard]] std::int64_t milliclocks(const firmware::Work& work) const;

  /// Cost of one operation in thousandths of a clock, before refresh.
  [[nodiscard]] std::int64_t milliclocks(firmware::Operation operation) const {
    return milliclocks_[static_cast<std::size_t>(operation)];
  }

 private:
  std::array<std::int64_t, firmware::k_operation_count> milliclocks_{};
  bool sums_fit_ = false;           // into 64 bits, whatever the counts of a Work are
  std::int64_t datum_milliclocks_;  // of a load
  Period milliclock_;
  Period elapsed_per_processor_ps_;
};

}  // namespace maquette::models
