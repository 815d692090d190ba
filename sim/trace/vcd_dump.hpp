#pragma once

#include <cstdint>
#include <queue>
#include <string>
#include <tuple>
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

struct SignalChange {
  models::Instant at;
  std::uint64_t number;  ///< in the order in which they were told
  std::uint64_t value;   ///< set; of an active-low signal added, modulo 2^64
  std::uint16_t signal;
  bool floats;
};

struct IsLaterChange {
  bool operator()(const SignalChange& a, const SignalChange& b) const {
    return std::tie(a.at, a.number) > std::tie(b.at, b.number);
  }
};

/// Signals and those of their changes that are told and not taken: a whole frame has some eight
/// million of them, more than should be held at once.
class VcdDump {
 public:
  std::uint16_t add(const std::string& scope, const std::string& name, SignalKind kind,
                    int bits = 1) {
    signals.push_back({scope, name, kind, bits});
    return static_cast<std::uint16_t>(signals.size() - 1);
  }

  void assert_during(std::uint16_t signal, models::Instant from, models::Instant to) {
    constexpr std::uint64_t k_minus_one = ~std::uint64_t{0};
    if (from < to) {
      tell(from, 1, signal, false);
      tell(to, k_minus_one, signal, false);
    }
  }

  void set(std::uint16_t signal, models::Instant at, std::uint64_t value) {
    tell(at, value, signal, false);
  }

  void release(std::uint16_t signal, models::Instant at) { tell(at, 0, signal, true); }

  /// Whether a change that was told comes before an instant.
  [[nodiscard]] bool has_before(models::Instant at) const {
    return !changes_.empty() && changes_.top().at < at;
  }

  /// Takes the earliest change, of one instant the one that was told first.
  SignalChange take() {
    const SignalChange change = changes_.top();
    changes_.pop();
    return change;
  }

  std::vector<DumpedSignal> signals;

 private:
  void tell(models::Instant at, std::uint64_t value, std::uint16_t signal, bool floats) {
    changes_.push({at, told_++, value, signal, floats});
  }

  std::priority_queue<SignalChange, std::vector<SignalChange>, IsLaterChange> changes_;
  std::uint64_t told_ = 0;
};

}  // namespace maquette::sim
