#pragma once

#include <stdexcept>

namespace maquette::sim {

/// What ends work that was asked to end before it has a result.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// From its construction on, Ctrl-C (SIGINT) and SIGTERM ask the run to end instead of killing the
/// program; a second one kills. The former behaviour comes back with the destructor.
class Interruption {
 public:
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  Interruption(Interruption&&) = delete;
  Interruption& operator=(Interruption&&) = delete;
  ~Interruption();

  [[nodiscard]] static bool is_requested();

  /// Throws Interrupted where it is.
  static void end_if_requested();
};

}  // namespace maquette::sim
