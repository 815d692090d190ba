#include "models/board/processor.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "models/board/long_word.hpp"
#include "models/bus/bus_error.hpp"
#include "models/bus/kernel_time.hpp"
#include "models/bus/versabus.hpp"

namespace maquette::models {

Processor::Processor(const Kvm02Parameters& parameters,
                     tlm::tlm_base_initiator_socket<>& bus_master, std::string name)
    : cost_(parameters),
      clock_(Period::of_frequency(parameters.clock_hz)),
      bus_master_(bus_master),
      name_(std::move(name)) {}

void Processor::start() { started_ = accounted_ = kernel_now(); }

void Processor::transact(BusBurst& burst) {
  burst.transaction.runs_ahead = promises_;
  sc_core::sc_time delay = to_sc_time(computing_);
  bus_master_->b_transport(burst.payload, delay);
  require_answer(burst.payload, burst.transaction, name_);
  if (!burst.transaction.follow_up) {
    account(burst.transaction, kernel_now());
  }
}

std::uint32_t Processor::peek_long(std::uint64_t address) {
  BusBurst read(tlm::TLM_READ_COMMAND);
  read.bytes.resize(k_long_bytes);
  read.aim(address);
  bus_master_->transport_dbg(read.payload);
  return long_of(read.bytes);
}

void Processor::account(const BusTransaction& transaction, Instant end) {
  states_.compute += computing_ + transaction.gaps();
  states_.wait_grant += transaction.waited;
  states_.transfer += transaction.transferred;
  states_.words += transaction.accesses;
  if (transaction.longest_wait > states_.longest_wait) {
    states_.longest_wait = transaction.longest_wait;
    states_.longest_wait_request = transaction.longest_wait_request;
  }
  computing_ = Duration::zero();
  accounted_ = end;
}

void Processor::pass() {
  if (seat_) {
    seat_->bus.promise(seat_->master, kernel_now() + computing_);
  }
  pass_computing();
}

void Processor::pass_computing() {
  sc_core::wait(to_sc_time(computing_));
  states_.compute += computing_;
  computing_ = Duration::zero();
  accounted_ = kernel_now();
}

void Processor::await(const sc_core::sc_event& event, Duration BoardStatistics::*state) {
  pause(state, [&] {
    if (seat_) {
      seat_->bus.rest(seat_->master);
    }
    awaited_ = &event;
    sc_core::wait(event);
    awaited_ = nullptr;
  });
}

void Processor::wake(sc_core::sc_event& event) {
  if (seat_ && awaited_ == &event) {
    seat_->bus.stir(seat_->master);
  }
  event.notify(sc_core::SC_ZERO_TIME);
}

void Processor::linger(Duration span, Duration BoardStatistics::*state) {
  pause(state, [&] {
    if (seat_) {
      seat_->bus.promise(seat_->master, kernel_now() + span);
    }
    sc_core::wait(to_sc_time(span));
    sc_core::wait(sc_core::SC_ZERO_TIME);
  });
}

template <class Wait>
void Processor::pause(Duration BoardStatistics::*state, Wait wait) {
  awaiting_ = state;
  if (observer_) {
    observer_(true, accounted_);
  }
  wait();
  awaiting_ = nullptr;
  if (observer_) {
    observer_(false, kernel_now());
  }
  states_.*state += kernel_now() - accounted_;
  accounted_ = kernel_now();
}

void Processor::finish() {
  pass_computing();
  states_.finished = accounted_;
}

BoardStatistics Processor::statistics(Instant instant) const {
  BoardStatistics statistics = states_;
  if (!started_) {
    return statistics;
  }
  if (statistics.compute + statistics.wait_grant + statistics.transfer + statistics.wait_unit +
          statistics.idle !=
      accounted_ - *started_) {
    throw std::logic_error(name_ + ": states do not sum to the elapsed time");
  }
  const Duration rest = instant - accounted_;
  if (statistics.finished) {
    statistics.idle += rest;
  } else if (awaiting_ != nullptr) {
    statistics.*awaiting_ += rest;
  } else {
    const Duration computed = std::min(rest, computing_);
    statistics.compute += computed;
    statistics.wait_grant += rest - computed;
  }
  return statistics;
}

}  // namespace maquette::models
