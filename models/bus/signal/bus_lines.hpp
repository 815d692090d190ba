#pragma once

#include <cstdint>
#include <systemc>

namespace maquette::models {

/// A line that terminators hold high and any board may pull low: a wired-or of active-low drivers,
/// one for each process that has written to it.
using BusLine = sc_core::sc_signal_resolved;

inline void pull(BusLine& line) { line.write(sc_dt::SC_LOGIC_0); }
inline void let_go(BusLine& line) { line.write(sc_dt::SC_LOGIC_Z); }
inline bool is_low(const BusLine& line) { return line.read() == sc_dt::SC_LOGIC_0; }

/// The lines of the backplane that a transfer takes, with the names of the VERSAbus (VM02 data
/// sheet p. 2-59; pin list). Those that end in _n are active low.
///
/// Assumptions: whoever has the bus leaves address and data as they were, which nobody reads
/// without a strobe; accesses are whole words, so both data strobes go together.
struct BusLines {
  static constexpr int k_levels = 5;

  /// Within the module under construction.
  BusLines();

  sc_core::sc_vector<BusLine> request;  ///< BR0..4
  sc_core::sc_vector<BusLine> grant;    ///< BG0..4, as the arbiter drives them
  BusLine busy;                         ///< BBSY: somebody has the bus
  BusLine clear;                        ///< BCLR: it is wanted at a higher level
  BusLine address_strobe;
  BusLine upper_strobe;  ///< DS0
  BusLine lower_strobe;  ///< DS1
  BusLine write;
  BusLine acknowledge;  ///< DTACK
  BusLine error;        ///< BERR
  sc_core::sc_signal<std::uint64_t, sc_core::SC_MANY_WRITERS> address;
  sc_core::sc_signal<std::uint32_t, sc_core::SC_MANY_WRITERS> data;
};

/// Whether a transfer's data strobes are low, for an address that is valid.
inline bool is_strobed(const BusLines& lines) {
  return is_low(lines.address_strobe) && is_low(lines.upper_strobe);
}

/// Waits, in a process, until a line is low or high.
inline void wait_for_low(const BusLine& line) {
  while (!is_low(line)) {
    sc_core::wait(line.value_changed_event());
  }
}
inline void wait_for_high(const BusLine& line) {
  while (is_low(line)) {
    sc_core::wait(line.value_changed_event());
  }
}

}  // namespace maquette::models
