#include "models/unit/errand_desk.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <tuple>

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

ErrandDesk::ErrandDesk(int board, const Kvm02Parameters& parameters, int in_flight,
                       const Site& site)
    : site_(site),
      board_(board),
      grant_([this](Errand& errand) { make_ready(errand); }),
      home_{site.mailbox, grant_},
      message_(site.bus.word_bytes()),
      something_ready_(("board" + std::to_string(board) + "_ready").c_str()) {
  if (in_flight < 1) {
    throw std::invalid_argument("a board must have a pixel in flight");
  }
  for (int i = 0; i < in_flight; ++i) {
    errands_.push_back(std::make_unique<Errand>());
    unused_.push_back(errands_.back().get());
  }
  BusTransaction& sending = message_.burst().transaction;
  sending.gap = Period::of_frequency(parameters.clock_hz).times(parameters.word_gap_clocks);
  sending.block = keeps_bus(parameters.release);
}

void ErrandDesk::run(const DispatchedBoard& board) {
  processor_ = &board.processor;
  while (true) {
    if (!ready_.empty()) {
      Errand& errand = *ready_.front();
      ready_.erase(ready_.begin());
      go_on(errand, board);
    } else if (!unused_.empty() && board.has_pixel()) {
      go_on(begin(board.take()), board);
    } else if (unused_.size() == errands_.size()) {
      return;
    } else {
      wait_for_units(board.processor);
    }
  }
}

Errand& ErrandDesk::begin(const SynthesizedPixel& pixel) {
  Errand& errand = *unused_.back();
  unused_.pop_back();
  errand.board = board_;
  errand.home = &home_;
  errand.number = begun_++;
  errand.pixel = pixel;
  site_.itinerary.make(site_.legs.legs(), errand.hops);
  errand.next = 0;
  return errand;
}

// Up to its next place with a unit, from there to the unit, or to its end. The board stays for the
// tick in which places are given, lest one that is free is kept while it works at another pixel.
void ErrandDesk::go_on(Errand& errand, const DispatchedBoard& board) {
  if (errand.place != nullptr) {
    send(errand, board.processor);
    return;
  }
  while (!errand.is_done() && errand.is_at_board()) {
    board.processor.take_on(errand.hop().time);
    ++errand.next;
  }
  if (errand.is_done()) {
    board.write(errand.pixel);
    unused_.push_back(&errand);
    return;
  }
  board.processor.pass();
  errand.last_kind = errand.hop().kind;
  const auto kind = static_cast<std::size_t>(errand.hop().kind);
  const Instant asked = kernel_now();
  site_.groups[kind]->ask(errand, grant_);
  board.processor.linger(k_tick, &BoardStatistics::wait_unit);
  waits_[kind] += kernel_now() - asked;
}

void ErrandDesk::send(Errand& errand, Processor& processor) {
  message_.address(errand.place->mailbox(), static_cast<std::uint32_t>(errand.number),
                   errand.hop().numbers_in);
  const Instant sent = processor.now();
  processor.transact(message_.burst());
  if (site_.handovers) {
    site_.handovers({board_, errand.place->number(), sent, kernel_now()});
  }
  errand.place->take(errand);
}

void ErrandDesk::make_ready(Errand& errand) {
  errand.since = kernel_now();
  const auto before = [](const Errand* a, const Errand* b) {
    const bool a_has_none = a->place == nullptr;
    const bool b_has_none = b->place == nullptr;
    return std::tie(a_has_none, a->since, a->number) < std::tie(b_has_none, b->since, b->number);
  };
  ready_.insert(std::upper_bound(ready_.begin(), ready_.end(), &errand, before), &errand);
  processor_->wake(something_ready_);
}

void ErrandDesk::wait_for_units(Processor& processor) {
  processor.pass();
  const Instant begin = processor.now();
  while (ready_.empty()) {
    processor.await(something_ready_, &BoardStatistics::wait_unit);
  }
  waits_[static_cast<std::size_t>(ready_.front()->last_kind)] += kernel_now() - begin;
}

}  // namespace maquette::models
