#include "models/unit/function_unit.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

FunctionUnit::FunctionUnit(const sc_core::sc_module_name& name,
                           const FunctionUnitParameters& parameters, const Kvm02Parameters& board,
                           const Site& site)
    : sc_module(name),
      bus_master("bus_master"),
      bus_port("bus_port"),
      site_(site),
      access_law_{Period::of_frequency(board.clock_hz), board.access_clocks, board.access_slack},
      access_time_(parameters.access_time),
      mailbox_(site.base + static_cast<std::uint64_t>(parameters.ram_bytes)),
      processor_(board, bus_master, this->name()),
      message_(site.bus.word_bytes()),
      arrived_("arrived"),
      granted_("granted"),
      grant_([this](Errand& /*errand*/) { processor_.wake(granted_); }) {
  if (parameters.ram_bytes < 0 || parameters.access_time < Duration::zero()) {
    throw std::invalid_argument("RAM and times of a function unit must not be negative");
  }
  bus_port.register_b_transport(this, &FunctionUnit::access);
  BusTransaction& sending = message_.burst().transaction;
  sending.gap = processor_.clock().times(board.word_gap_clocks);
  sending.block = keeps_bus(board.release);
  SC_HAS_PROCESS(FunctionUnit);
  SC_THREAD(run);
}

void FunctionUnit::run() {
  sc_core::wait(site_.start);
  processor_.start();
  while (true) {
    Errand& errand = next_errand();
    const std::uint32_t results = errand.hop().numbers_out;
    processor_.take_on(errand.hop().time);
    errand.last_kind = errand.hop().kind;
    ++errand.next;
    hand_on(errand, results);
    --load_;
    last_end_ = kernel_now();
  }
}

Errand& FunctionUnit::next_errand() {
  while (queue_.empty()) {
    processor_.await(arrived_, &BoardStatistics::idle);
  }
  Errand& errand = *queue_.front();
  queue_.erase(queue_.begin());
  queued_.add(kernel_now() - errand.since);
  ++errands_;
  errand.place = nullptr;
  --places_taken_;
  last_begin_ = kernel_now();
  site_.group.freed();
  return errand;
}

void FunctionUnit::hand_on(Errand& errand, std::uint32_t results) {
  const auto pixel = static_cast<std::uint32_t>(errand.number);
  if (errand.is_at_board()) {
    message_.address(errand.home->mailbox, pixel, results);
    send(errand.board);
    errand.home->take_back(errand);
    return;
  }
  processor_.pass();
  site_.groups[static_cast<std::size_t>(errand.hop().kind)]->ask(errand, grant_);
  while (errand.place == nullptr) {
    processor_.await(granted_, &BoardStatistics::wait_unit);
  }
  message_.address(errand.place->mailbox(), pixel, results + errand.hop().numbers_in);
  send(errand.place->number());
  errand.place->take(errand);
}

void FunctionUnit::send(int to) {
  const Instant sent = processor_.now();
  processor_.transact(message_.burst());
  if (site_.handovers) {
    site_.handovers({number(), to, sent, kernel_now()});
  }
}

int FunctionUnit::places_taken() const {
  return places_taken_ + (last_begin_ == kernel_now() ? 1 : 0);
}

int FunctionUnit::load() const { return load_ + (last_end_ == kernel_now() ? 1 : 0); }

// On a bus without arbitration messages may end in one instant.
void FunctionUnit::take(Errand& errand) {
  errand.since = kernel_now();
  const auto before = [](const Errand* a, const Errand* b) {
    return std::tie(a->since, a->board, a->number) < std::tie(b->since, b->board, b->number);
  };
  queue_.insert(std::upper_bound(queue_.begin(), queue_.end(), &errand, before), &errand);
  longest_queue_ = std::max(longest_queue_, static_cast<int>(queue_.size()));
  processor_.wake(arrived_);
}

void FunctionUnit::access(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
  delay += to_sc_time(access_time_);
  payload.set_response_status(tlm::TLM_OK_RESPONSE);
}

FunctionUnitStatistics FunctionUnit::statistics(Instant instant) const {
  return {name(), processor_.statistics(instant), errands_, queued_, longest_queue_};
}

}  // namespace maquette::models
