#pragma once

#include <cstdint>

#include "models/bus/access_law.hpp"
#include "models/bus/signal/bus_lines.hpp"

namespace maquette::models {

/// How a transfer over the lines ended.
struct TransferEnd {
  Duration slave_time;  ///< from the strobe to DTACK, or to BERR if there was none
  bool is_error;
};

/// The bus cycles of a processor that has the bus: what it does with strobes, WRITE, address and
/// data, in its own process.
///
/// The processor looks at DTACK at its own clock: for the first time `access_slack` after the
/// strobe, then once per clock; an answer of the very instant counts. The look that finds it low
/// says how many clocks the cycle waited; where `access_slack` is longer than the cycle, it ends
/// with the clock in which DTACK falls. BERR without DTACK, from the bus timer, ends it at once.
class BusCycle {
 public:
  /// The lines are kept by reference.
  BusCycle(const AccessLaw& law, BusLines& lines) : law_(law), lines_(lines) {}

  /// The address strobe falls with the first data strobe of the access, and rises at its end.
  void begin(std::uint64_t address);
  void end();

  /// One transfer of a word between them: written, or read unless there is an error.
  TransferEnd write(std::uint32_t word);
  TransferEnd read(std::uint32_t& word);

 private:
  TransferEnd strobe();
  void wait_for_answer() const;
  void wait_out_clocks(Instant strobe) const;
  void release();

  AccessLaw law_;
  BusLines& lines_;
};

}  // namespace maquette::models
