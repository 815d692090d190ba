#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <systemc>
#include <tlm>
#include <utility>

#include "firmware/arithmetic/work.hpp"
#include "models/board/board_statistics.hpp"
#include "models/board/kvm02_parameters.hpp"
#include "models/board/pixel_meter.hpp"
#include "models/board/work_cost.hpp"
#include "models/bus/bus_burst.hpp"
#include "models/bus/instant.hpp"
#include "models/bus/period.hpp"
#include "models/bus/time_limit.hpp"

namespace maquette::models {

class VersaBus;

/// Whether a processor has nothing to do from an instant on until some event.
using PauseObserver = std::function<void(bool pauses, Instant from)>;

/// The time of a board's processor, and what it did with it.
///
/// It runs ahead of the kernel on its private memory: the kernel sees only its bus transactions.
/// What it has computed since the last one is the time from there to its next request.
class Processor {
 public:
  /// The socket is kept by reference; `name` is that of the board, for messages. Throws as Period
  /// and WorkCost.
  Processor(const Kvm02Parameters& parameters, tlm::tlm_base_initiator_socket<>& bus_master,
            std::string name);

  /// The frame starts, in the kernel's present instant.
  void start();

  /// Reports a computation that does not end within the longest simulated time.
  void compute(Duration time) {
    require_in_time(now(), time, name_);
    computing_ += time;
  }
  void compute(Clocks clocks) { compute(clock_.times(clocks)); }

  /// How long so many clocks take, with the refresh of the RAM.
  [[nodiscard]] Duration time_of(Clocks clocks) const {
    constexpr std::int64_t k_milliclocks = 1000;
    return cost_.elapsed(k_milliclocks * clocks);
  }

  /// How long `work` takes, of whose loads `bus_loads` get their datum over the bus. It is to be
  /// computed next.
  [[nodiscard]] Duration take_on(const firmware::Work& work, std::int64_t bus_loads = 0) {
    const Duration time = cost_.duration(work, bus_loads);
    states_.working += time;
    return time;
  }
  /// Work whose time is known is to be computed next.
  void take_on(Duration time) {
    states_.working += time;
    compute(time);
  }

  [[nodiscard]] const Period& clock() const { return clock_; }

  /// Computes for as long as is due, then does the burst; returns at its end. Reports a bus error.
  void transact(BusBurst& burst);

  /// A long word on the bus as it is now, without an access.
  [[nodiscard]] std::uint32_t peek_long(std::uint64_t address);

  /// Puts a burst that has ended into the states. `transact` does it for a burst that nothing
  /// follows up.
  void account(const BusTransaction& transaction, Instant end);

  /// Computes for as long as is due; returns at its end. Only of a processor that tells or does not
  /// promise.
  void pass();

  /// Waits for an event, in a state of its statistics. Only of a processor that has nothing left to
  /// compute and tells, or does not promise.
  void await(const sc_core::sc_event& event, Duration BoardStatistics::*state);

  /// Notifies an event for which it may be waiting, in this instant.
  void wake(sc_core::sc_event& event);

  /// Waits for a span, in a state of its statistics, and for what others do in its last instant.
  /// Only as `await`.
  void linger(Duration span, Duration BoardStatistics::*state);

  /// When it begins to wait for events, and when it goes on, is shown to `observer`.
  void observe_pauses(PauseObserver observer) { observer_ = std::move(observer); }

  /// From now on it does not promise the bus to request as soon as the kernel wakes it.
  void promise_nothing() { promises_ = false; }

  /// From now on it tells its bus, as the master of a number, until when it computes and that it
  /// waits for events, so that the bus need not wait for it. The bus is kept by reference.
  void tell(VersaBus& bus, int master) { seat_.emplace(Seat{bus, master}); }

  /// Computes for as long as is due: its last work has ended.
  void finish();

  /// Since the last transaction.
  [[nodiscard]] Duration computing() const { return computing_; }

  /// The instant that it has reached.
  [[nodiscard]] Instant now() const { return accounted_ + computing_; }

  /// What it has done with its time since the start of the frame.
  [[nodiscard]] ProcessorTime spent() const {
    return {states_.compute + computing_, states_.wait_grant + states_.wait_unit, states_.transfer};
  }

  /// Up to here its states are known, perhaps ahead of the kernel.
  [[nodiscard]] Instant accounted() const { return accounted_; }

  [[nodiscard]] std::optional<Instant> finished() const { return states_.finished; }

  /// Its states, words and longest wait; see Kvm02::statistics. Throws std::logic_error when the
  /// states do not sum to the time that has passed.
  [[nodiscard]] BoardStatistics statistics(Instant instant) const;

 private:
  struct Seat {
    VersaBus& bus;
    int master;
  };

  void pass_computing();
  template <class Wait>
  void pause(Duration BoardStatistics::*state, Wait wait);

  WorkCost cost_;
  Period clock_;
  tlm::tlm_base_initiator_socket<>& bus_master_;
  std::string name_;
  std::optional<Instant> started_;
  Instant accounted_{};
  Duration computing_{};
  bool promises_ = true;
  std::optional<Seat> seat_;  // where it tells
  const sc_core::sc_event* awaited_ = nullptr;
  Duration BoardStatistics::*awaiting_ = nullptr;  // the state in which it waits for an event
  PauseObserver observer_;
  BoardStatistics states_;
};

}  // namespace maquette::models
