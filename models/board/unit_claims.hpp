#pragma once

#include <cstdint>

#include "models/board/allotment_parameters.hpp"
#include "models/board/processor.hpp"
#include "models/board/shared_memory.hpp"
#include "models/board/starvation_watch.hpp"
#include "models/bus/bus_burst.hpp"

namespace maquette::models {

/// How a board claims units that it shares with the others: it takes the lock of their counter by
/// test-and-set, reads the counter, writes it back greater by one and clears the lock.
class UnitClaims {
 public:
  /// Bus and processor are kept by reference.
  UnitClaims(const ClaimParameters& parameters, std::int64_t boards, const SharedWindow& shared,
             const VersaBus& bus, Processor& processor);

  /// Claims the next unit; behind the last one there is none left. Reports an error when the board
  /// that holds the lock starves.
  [[nodiscard]] std::int64_t next();

  [[nodiscard]] Duration time() const { return time_; }
  [[nodiscard]] std::int64_t claims() const { return claims_; }
  [[nodiscard]] std::int64_t failed_tries() const { return failed_tries_; }

 private:
  void take_lock();
  void clear_lock();
  [[nodiscard]] bool test_and_set();
  [[nodiscard]] std::uint32_t read_counter();
  void write_counter(std::uint32_t unit);

  ClaimParameters parameters_;
  std::int64_t boards_;
  SharedWindow shared_;
  unsigned word_bytes_;
  Processor& processor_;
  StarvationWatch watch_;
  BusBurst tas_{tlm::TLM_READ_COMMAND};
  BusBurst read_{tlm::TLM_READ_COMMAND};
  BusBurst write_{tlm::TLM_WRITE_COMMAND};
  Duration time_{};  // from the first try to the last step
  std::int64_t claims_ = 0;
  std::int64_t failed_tries_ = 0;
};

}  // namespace maquette::models
