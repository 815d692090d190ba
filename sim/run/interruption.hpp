#pragma once

#include "firmware/arithmetic/stop_request.hpp"

namespace maquette::sim {

/// From its construction on, Ctrl-C (SIGINT) and SIGTERM ask the run to end (stop_request.hpp)
/// instead of killing the program; a second one kills. The former behaviour comes back with the
/// destructor.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  Interruption(Interruption&&) = delete;
  Interruption& operator=(Interruption&&) = delete;
  ~Interruption();

  [[nodiscard]] static bool is_requested() { return firmware::stop_requested.load(); }
};

}  // namespace maquette::sim
