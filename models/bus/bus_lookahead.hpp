#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "models/bus/instant.hpp"

namespace maquette::models {

/// How far a bus may decide ahead of the kernel: what it knows of its masters' future.
///
///              activate              post, at any instant
///   retired --------------> computing --------------------> requesting <--+  next access, or a
///     ^  ^                   |   ^                            |  |  |     |  burst that follows up
///     |  +-------------------+   +----------------------------+  |  +-----+
///     |   retire, at any instant    end of a burst, no promise   |
///     |                                                          |  end E of a burst, with the
///     |        retire, in E                                      |  promise to run ahead
///     +-------------------------- promised <---------------------+
///                                    |
///                                    +---- post, in E ----> requesting
///
/// A master that computes may post in any instant of the kernel from its present one on. One that
/// has promised (BusTransaction::runs_ahead) posts or retires in the instant E in which the kernel
/// wakes it, neither earlier nor later. So, of a decision at instant D by requests that are known:
/// - when nobody computes or has promised, or the arbiter does not heed whom it does not know of,
///   nothing unknown can come before D: it is taken at once, however far it is ahead of the kernel,
///   up to the horizon, to which the bus has the kernel wake it;
/// - while a master computes, it is taken once the kernel is past D: the bus has the kernel wake it
///   one tick after D;
/// - while masters have promised but none computes, no wake-up is needed: the bus goes on when the
///   first of them calls.
class BusLookahead {
 public:
  /// A new master, which computes. `name` is for messages.
  void add_master(const std::string& name);

  // What the drawing does not have is reported as misuse. `now` is the kernel's instant.

  /// The master waits with a request of instant `request` from now on.
  void post(int master, Instant request, Instant now);

  /// Of a master that is requesting: its next access.
  void request_next(int master, Instant request) { at(master).instant = request; }

  /// Of a master that is requesting: its last access ends.
  void end(int master, Instant end, bool promised);

  void retire(int master, Instant now);
  void activate(int master, Instant now);

  /// From which instant of the kernel on the bus may take a decision of instant `decision`: at most
  /// `now` if at once, k_never if a master will call before.
  [[nodiscard]] Instant decidable_from(Instant decision, bool heeds_unknown, Instant now) const {
    if (heeds_unknown && decision >= now && computing_ + promised_ > 0) {
      return computing_ > 0 ? decision + k_tick : k_never;
    }
    return decision < now + k_horizon ? now : decision;
  }

  /// The bus takes a decision.
  void decide(Instant decision) {
    last_decision_ = decision > last_decision_ ? decision : last_decision_;
  }

  /// When the request began, or will begin, that a master waits with; nothing if it has none.
  [[nodiscard]] std::optional<Instant> standing_request(int master) const;

 private:
  enum class State { computing, promised, requesting, retired };

  struct Master {
    std::string name;
    State state = State::computing;
    Instant instant{};  // requesting: of its request; promised: E
  };

  /// The bus goes no further ahead of the kernel, so that a run can be watched and ended.
  static constexpr Duration k_horizon = std::chrono::seconds(1);

  void leave_computing(Master& master, State next, Instant now);
  [[nodiscard]] Master& at(int master) { return masters_[static_cast<std::size_t>(master)]; }

  std::vector<Master> masters_;
  int computing_ = 0;
  int promised_ = 0;
  Instant last_decision_{-1};
};

}  // namespace maquette::models
