#pragma once

#include <algorithm>
#include <cstdint>

#include "models/board/mc68000/account.hpp"

namespace maquette::models::mc68000 {

/// Counts what instructions cost. They run in slices: what a slice costs is pending in one packed
/// word, which is settled into the account when the slice ends.
class CycleCounter {
 public:
  /// What was used up to the last settlement.
  [[nodiscard]] const Account& account() const { return account_; }

  /// Begins a slice that ends when the account's cycles reach `limit`, or earlier.
  void begin_slice(std::uint64_t limit) {
    const std::uint64_t left = limit > account_.cycles ? limit - account_.cycles : 0;
    slice_end_ =
        packed_cycles(static_cast<unsigned>(std::min<std::uint64_t>(left, k_slice_cycles)));
  }

  /// Lets the slice end with the instruction that is being executed.
  void end_slice() { slice_end_ = 0; }

  [[nodiscard]] bool slice_goes_on() const { return pending_ < slice_end_; }

  void charge(PackedCost cost) { pending_ += cost; }
  void charge_cycles(unsigned cycles) { pending_ += packed_cycles(cycles); }

  /// Charges what may be too much for a slice, as whole routines are.
  void charge_at_once(const InstructionCost& cost) {
    account_.add(cost);
    end_slice();
  }

  /// Counts an access outside of the RAM and its wait states. Ends the slice.
  void count_outside(const Account& access) {
    account_.cycles += access.bus_wait_cycles;
    account_.bus_wait_cycles += access.bus_wait_cycles;
    account_.bus_fetches += access.bus_fetches;
    account_.bus_reads += access.bus_reads;
    account_.bus_writes += access.bus_writes;
    account_.bus_modifications += access.bus_modifications;
    end_slice();
  }

  /// Brings the pending cost to account.
  void settle() {
    account_.add(unpacked(pending_));
    pending_ = 0;
  }

 private:
  // The dearest instruction takes less than 300 cycles, so that a slice cannot overflow.
  static constexpr unsigned k_slice_cycles = k_most_packed_cycles / 2;

  PackedCost pending_ = 0;
  PackedCost slice_end_ = 0;
  Account account_;
};

}  // namespace maquette::models::mc68000
