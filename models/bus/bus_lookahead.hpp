#pragma once

#include <algorithm>
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
///     ^  ^                   |   ^  |                         |  |  |     |  burst that follows up
///     |  +-------------------+   |  +---> promise, rest       |  |  +-----+
///     |   retire, at any instant +----------------------------+  |
///     |                              end of a burst, no promise  |  end E of a burst, with the
///     |                                                          |  promise to run ahead
///     |        retire, in E                                      |
///     +-------------------------- promised <---------------------+
///                                 ^  |  |
///      promise of a later E, in E +--+  +---- post, in E ----> requesting
///                                 |
///                 stir: E is now  +----- resting <---- rest, in E
///
/// A master that computes may post in any instant of the kernel from its present one on. One that
/// has promised (BusTransaction::runs_ahead, or by `promise`) posts, retires, rests or promises
/// anew in the instant E, neither earlier nor later. One that rests does nothing until whatever it
/// waits for stirs it: another master, or a bystander, which is no master, has no request, and says
/// by `expect` when it acts next. So, of a decision at instant D by requests that are known:
/// - when nobody computes, or has promised or expects anything up to D, or the arbiter does not
///   heed whom it does not know of, nothing unknown can come up to D: it is taken at once, however
///   far it is ahead of the kernel, up to the horizon, to which the bus has the kernel wake it;
/// - while a master computes, it is taken once the kernel is past D: the bus has the kernel wake it
///   one tick after D;
/// - while none computes but one has promised, or expects, something up to D, no wake-up is needed:
///   the bus goes on when the first of them calls.
class BusLookahead {
 public:
  /// A new master, which computes. `name` is for messages.
  void add_master(const std::string& name);

  /// A new bystander's number, which expects nothing.
  int add_bystander();

  // What the drawing does not have is reported as misuse. `now` is the kernel's instant.

  /// The master waits with a request of instant `request` from now on.
  void post(int master, Instant request, Instant now);

  /// Of a master that is requesting: its next access.
  void request_next(int master, Instant request) { at(master).instant = request; }

  /// Of a master that is requesting: its last access ends.
  void end(int master, Instant end, bool promised);

  /// The master posts, retires, rests or promises anew at `instant`.
  void promise(int master, Instant instant, Instant now);

  /// The master does nothing until it is stirred.
  void rest(int master, Instant now);

  /// A resting master goes on now; nothing for others.
  void stir(int master, Instant now);

  /// The bystander acts at `instant`; k_never for not at all.
  void expect(int bystander, Instant instant);

  void retire(int master, Instant now);
  void activate(int master, Instant now);

  /// From which instant of the kernel on the bus may take a decision of instant `decision`: at most
  /// `now` if at once, k_never if a master or a bystander will call before.
  [[nodiscard]] Instant decidable_from(Instant decision, bool heeds_unknown, Instant now) const {
    if (heeds_unknown && decision >= now) {
      if (computing_ > 0) {
        return decision + k_tick;
      }
      if (decision >= earliest_act()) {
        return k_never;
      }
    }
    return decision < now + k_horizon ? now : decision;
  }

  /// Up to which instant, excluded, a bus that heeds whom it does not know of may go at once.
  [[nodiscard]] Instant known_until(Instant now) const {
    return computing_ > 0 ? now : std::min(earliest_act(), now + k_horizon);
  }

  /// The bus takes a decision.
  void decide(Instant decision) {
    last_decision_ = decision > last_decision_ ? decision : last_decision_;
  }

  /// When the request began, or will begin, that a master waits with; nothing if it has none.
  [[nodiscard]] std::optional<Instant> standing_request(int master) const;

 private:
  enum class State { computing, promised, requesting, resting, retired };

  struct Master {
    std::string name;
    State state = State::computing;
    Instant instant{};  // requesting: of its request; promised: E
  };

  /// The bus goes no further ahead of the kernel, so that a run can be watched and ended.
  static constexpr Duration k_horizon = std::chrono::seconds(1);

  /// Of all that is promised or expected; k_never for nothing.
  [[nodiscard]] Instant earliest_act() const {
    if (!earliest_act_) {
      earliest_act_ = find_earliest_act();
    }
    return *earliest_act_;
  }
  [[nodiscard]] Instant find_earliest_act() const;
  void set_promised(Master& master, Instant instant);
  void leave(Master& master, State next, Instant now);
  [[nodiscard]] Master& at(int master) { return masters_[static_cast<std::size_t>(master)]; }

  std::vector<Master> masters_;
  std::vector<Instant> bystanders_;  // when each acts next
  int computing_ = 0;
  mutable std::optional<Instant> earliest_act_;  // where it is known
  Instant last_decision_{-1};
};

}  // namespace maquette::models
