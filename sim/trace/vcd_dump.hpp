#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "models/bus/instant.hpp"

namespace maquette::sim {

/// How a signal's changes make its value.
enum class SignalKind {
  active_low,  ///< a count of those that assert it: 0 above zero
  vector       ///< the last value set; may float
};

/// A signal of a value change dump.
struct DumpedSignal {
  std::string scope;
  std::string name;
  SignalKind kind;
  int bits;
};

/// In 16 bytes: a whole frame has some eight million of them.
struct SignalChange {
  models::Instant at;
  std::uint32_t value;  ///< set; of an active-low signal added, modulo 2^32
  std::uint16_t signal;
  bool floats;
};

/// Signals and all their changes, in any order.
class VcdDump {
 public:
  std::uint16_t add(const std::string& scope, const std::string& name, SignalKind kind,
                    int bits = 1) {
    signals.push_back({scope, name, kind, bits});
    return static_cast<std::uint16_t>(signals.size() - 1);
  }

  void assert_during(std::uint16_t signal, models::Instant from, models::Instant to) {
    constexpr std::uint32_t k_minus_one = ~std::uint32_t{0};
    if (from < to) {
      changes.push_back({from, 1, signal, false});
      changes.push_back({to, k_minus_one, signal, false});
    }
  }

  void set(std::uint16_t signal, models::Instant at, std::uint32_t value) {
    changes.push_back({at, value, signal, false});
  }

  void release(std::uint16_t signal, models::Instant at) {
    changes.push_back({at, 0, signal, true});
  }

  std::vector<DumpedSignal> signals;
  std::vector<SignalChange> changes;
};

}  // namespace maquette::sim
