#pragma once

#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <cmath>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <systemc>
#include <tlm>
#include <vector>

#include "models/bus/kernel_time.hpp"
#include "models/bus/versabus.hpp"

/// Masters and slaves for tests of the bus.
namespace maquette::models::traffic {

/// One transaction of a master: what it does before, and its burst.
struct Step {
  Duration compute;
  std::uint64_t address = 0;
  int accesses = 1;
  Duration gap{};
  bool block = false;
  tlm::tlm_command command = tlm::TLM_WRITE_COMMAND;
  bool test_and_set = false;  // of one that reads
  Duration modify{};
  bool one_place = false;  // all words go to one long word
};

/// How a master spends its compute time: told to the bus as delay, with or without the promise to
/// run ahead, or waited for in the kernel; or one burst follows up the other without a way through
/// the kernel; or it is waited for, and its end told to the bus.
enum class Style { promised, annotated, waiting, followed_up, told };

/// A transaction as its master saw it.
struct Outcome {
  Instant end;
  Duration waited;
  Duration transferred;
  Duration longest_wait;
  tlm::tlm_response_status status;
};

/// A slave whose access time is a function of the data strobe's instant; remembers its last word.
class Slave : public sc_core::sc_module {
 public:
  Slave(const sc_core::sc_module_name& name, std::function<Duration(Instant)> access_time)
      : sc_module(name), socket("socket"), access_time_(std::move(access_time)) {
    socket.register_b_transport(this, &Slave::b_transport);
  }

  tlm_utils::simple_target_socket<Slave> socket;

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    delay += to_sc_time(access_time_(payload.get_extension<BusStrobe>()->instant));
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }

  std::function<Duration(Instant)> access_time_;
};

/// A master that does step after step until `next` returns false, and then retires.
class Master : public sc_core::sc_module {
 public:
  using Next = std::function<bool(Step&)>;

  Master(const sc_core::sc_module_name& name, VersaBus& bus, const BusMasterPlace& place,
         const AccessLaw& access, Style style, Next next)
      : sc_module(name),
        socket("socket"),
        bus_(bus),
        id_(bus.attach_master(socket, {this->name(), place, access})),
        style_(style),
        next_(std::move(next)) {
    SC_HAS_PROCESS(Master);
    SC_THREAD(run);
  }

  tlm_utils::simple_initiator_socket<Master> socket;
  std::vector<Outcome> outcomes;

 private:
  void run() {
    payload_.set_extension(&transaction_);
    transaction_.runs_ahead = style_ == Style::promised || style_ == Style::told;
    if (style_ == Style::followed_up) {
      transaction_.follow_up = [this](Instant end) { return follow_up(end); };
    }
    Step step;
    while (next_(step)) {
      load(step);
      sc_core::sc_time delay = to_sc_time(step.compute);
      if (style_ == Style::told) {
        bus_.promise(id_, kernel_now() + step.compute);
      }
      if (style_ == Style::waiting || style_ == Style::told) {
        sc_core::wait(delay);
        delay = sc_core::SC_ZERO_TIME;
      }
      socket->b_transport(payload_, delay);
      if (!transaction_.follow_up || payload_.get_response_status() != tlm::TLM_OK_RESPONSE) {
        keep_outcome(kernel_now() + to_duration(delay));
      }
    }
    bus_.retire(id_);
  }

  void load(const Step& step) {
    data_.resize(static_cast<std::size_t>(step.accesses) * bus_.word_bytes());
    std::iota(data_.begin(), data_.end(), static_cast<unsigned char>(++steps_));
    transaction_.gap = step.gap;
    transaction_.block = step.block;
    transaction_.test_and_set = step.test_and_set;
    transaction_.modify = step.modify;
    transaction_.addresses.clear();
    constexpr unsigned k_long_bytes = 4;
    for (int i = 0; step.one_place && i < step.accesses; ++i) {
      const unsigned word = static_cast<unsigned>(i) * bus_.word_bytes();
      transaction_.addresses.push_back(step.address + word % k_long_bytes);
    }
    payload_.set_command(step.command);
    payload_.set_address(step.address);
    payload_.set_data_ptr(data_.data());
    payload_.set_data_length(static_cast<unsigned>(data_.size()));
  }

  void keep_outcome(Instant end) {
    outcomes.push_back({end, transaction_.waited, transaction_.transferred,
                        transaction_.longest_wait, payload_.get_response_status()});
  }

  std::optional<Duration> follow_up(Instant end) {
    keep_outcome(end);
    Step step;
    if (!next_(step)) {
      return std::nullopt;
    }
    load(step);
    return step.compute;
  }

  BusTransaction transaction_;  // before the payload, which frees its extensions
  tlm::tlm_generic_payload payload_;
  std::vector<unsigned char> data_;
  unsigned steps_ = 0;
  VersaBus& bus_;
  int id_;
  Style style_;
  Next next_;
};

/// The steps of a list, one after the other.
inline Master::Next script(std::vector<Step> steps) {
  return [steps = std::move(steps), at = std::size_t{0}](Step& step) mutable {
    if (at == steps.size()) {
      return false;
    }
    step = steps[at++];
    return true;
  };
}

/// The same step `times` times.
inline Master::Next repeat(const Step& repeated, int times) {
  return script(std::vector<Step>(static_cast<std::size_t>(times), repeated));
}

/// A processor of 8 MHz with the KVM02's access law.
inline AccessLaw board_access() { return {Period::of_frequency(8e6), 5, Duration{70'000}}; }

/// A number in ]0, 1] from a generator, the same with every standard library.
inline double unit(std::mt19937& generator) {
  return (static_cast<double>(generator()) + 1) / 4294967296.0;
}

/// A whole number in [0, n[.
inline int below(std::mt19937& generator, int n) {
  return static_cast<int>(generator() % static_cast<unsigned>(n));
}

/// A bus with one slave on all addresses below 2^24 and scripted masters, which logs every access.
struct Bench {
  Bench(const std::string& name, const VersaBusParameters& parameters,
        const std::function<Duration(Instant)>& access_time)
      : bus((name + "_bus").c_str(), parameters),
        slave((name + "_slave").c_str(), access_time),
        name_(name) {
    bus.attach_slave(slave.socket, {"slave", 0, 1U << 24U});
    bus.observe([this](const BusAccess& access) { log.push_back(access); });
  }

  Master& add(const BusMasterPlace& place, Style style, Master::Next next,
              const AccessLaw& access = board_access()) {
    masters.push_back(
        std::make_unique<Master>((name_ + "_master" + std::to_string(masters.size())).c_str(), bus,
                                 place, access, style, std::move(next)));
    return *masters.back();
  }

  VersaBus bus;
  Slave slave;
  std::vector<std::unique_ptr<Master>> masters;
  std::vector<BusAccess> log;

 private:
  std::string name_;
};

/// A slave's access time that is always the same.
inline std::function<Duration(Instant)> always(Duration time) {
  return [time](Instant /*strobe*/) { return time; };
}

}  // namespace maquette::models::traffic
