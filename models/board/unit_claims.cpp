#include "models/board/unit_claims.hpp"

#include "models/board/long_word.hpp"

namespace maquette::models {

// A byte takes a whole word of the bus.
UnitClaims::UnitClaims(const ClaimParameters& parameters, std::int64_t boards,
                       const SharedWindow& shared, const VersaBus& bus, Processor& processor)
    : parameters_(parameters),
      boards_(boards),
      shared_(shared),
      word_bytes_(bus.word_bytes()),
      processor_(processor),
      watch_(bus, processor, shared.next_unit()) {
  tas_.transaction.test_and_set = true;
  tas_.transaction.modify = processor.clock().times(parameters.modify_clocks);
  tas_.bytes.resize(word_bytes_);
  tas_.aim(shared.lock());
  read_.bytes.resize(k_long_bytes);
  read_.aim(shared.next_unit());
}

std::int64_t UnitClaims::next() {
  const Instant begin = processor_.now();
  take_lock();
  processor_.compute(parameters_.read_clocks);
  const std::uint32_t unit = read_counter();
  processor_.compute(parameters_.update_clocks);
  write_counter(unit + 1);
  processor_.compute(parameters_.unlock_clocks);
  clear_lock();
  processor_.compute(parameters_.finish_clocks);
  ++claims_;
  time_ += processor_.now() - begin;
  return unit;
}

void UnitClaims::take_lock() {
  while (!test_and_set()) {
    ++failed_tries_;
    watch_.count_failure();
    processor_.compute(parameters_.spin_clocks * boards_);
  }
  watch_.count_success();
}

bool UnitClaims::test_and_set() {
  processor_.transact(tas_);
  return (tas_.bytes.front() & SharedWindow::k_taken) == 0;
}

void UnitClaims::clear_lock() {
  write_.bytes.assign(word_bytes_, 0);
  write_.aim(shared_.lock());
  processor_.transact(write_);
}

// The words of a long word follow one another without a gap.
std::uint32_t UnitClaims::read_counter() {
  processor_.transact(read_);
  return long_of(read_.bytes);
}

void UnitClaims::write_counter(std::uint32_t unit) {
  write_.bytes.clear();
  append_long(unit, write_.bytes);
  write_.aim(shared_.next_unit());
  processor_.transact(write_);
}

}  // namespace maquette::models
