#pragma once

#include <cstdint>

#include "firmware/arithmetic/work.hpp"
#include "models/board/database_cache.hpp"
#include "models/board/processor.hpp"
#include "models/board/shared_memory.hpp"
#include "models/bus/bus_burst.hpp"

namespace maquette::models {

/// How a board reads a database that it shares with the others: as often as the work says, spread
/// evenly over the time of the work. Assumption: the reads go through the database in order, since
/// only their number matters.
class DatabaseReader {
 public:
  /// The processor is kept by reference.
  DatabaseReader(std::int64_t cache_bytes, const SharedWindow& shared, unsigned word_bytes,
                 Processor& processor);

  /// Lets the time of `work` pass, and reads over the bus what misses the cache.
  void compute(const firmware::Work& work);

  /// Read so far.
  [[nodiscard]] std::int64_t words() const { return words_; }

 private:
  void read(Duration computing, std::int64_t loads);
  void set_addresses(std::int64_t loads);

  DatabaseCache cache_;
  SharedWindow shared_;
  unsigned word_bytes_;
  Processor& processor_;
  BusBurst burst_{tlm::TLM_READ_COMMAND};
  std::uint64_t offset_ = 0;  // of the next read
  std::int64_t words_ = 0;
};

}  // namespace maquette::models
