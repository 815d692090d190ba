#pragma once

#include <string>
#include <systemc>

#include "models/bus/instant.hpp"

namespace maquette::models {

/// Requires that what `who` does from an instant on ends within k_longest_run; else an exception
/// out of the kernel's run says who it is. Neither time is negative, and the instant is within it.
inline void require_in_time(Instant from, Duration time, const std::string& who) {
  if (time > k_longest_run - from) {
    const std::string message =
        who +
        " is not done within 100 days, the longest simulated time; a faster clock, cheaper "
        "work, more boards or fewer pixels take less";
    SC_REPORT_ERROR("/maquette/time", message.c_str());
  }
}

}  // namespace maquette::models
