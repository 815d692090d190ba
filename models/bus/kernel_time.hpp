#pragma once

#include <systemc>

#include "models/bus/instant.hpp"

namespace maquette::models {

/// A span as the kernel's time; its resolution is the default one, 1 ps. `span` is not negative.
inline sc_core::sc_time to_sc_time(Duration span) {
  return sc_core::sc_time::from_value(static_cast<sc_core::sc_time::value_type>(span.count()));
}

/// The kernel's time in picoseconds.
inline Duration to_duration(const sc_core::sc_time& time) {
  return Duration{static_cast<Duration::rep>(time.value())};
}

/// The kernel's present instant.
inline Instant kernel_now() { return to_duration(sc_core::sc_time_stamp()); }

}  // namespace maquette::models
