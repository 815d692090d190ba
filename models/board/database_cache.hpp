#pragma once

#include <algorithm>
#include <cstdint>

namespace maquette::models {

/// Which of a board's reads of a shared database miss its cache.
///
/// Assumption: reads fall uniformly on the database and a long word replaces any other, so a full
/// cache hits with probability cache / database. The law is followed exactly, without chance: the
/// fraction of a miss that a pixel leaves over is carried to the next. Until the cache is full,
/// what would have hit misses as well, once for each long word of the cache.
class DatabaseCache {
 public:
  /// Both in bytes, the database's positive.
  DatabaseCache(std::int64_t cache_bytes, std::int64_t database_bytes)
      : cached_(std::min(cache_bytes, database_bytes)),
        database_(database_bytes),
        cold_(cached_ / k_long_bytes) {}

  /// How many of the next `loads` miss.
  [[nodiscard]] std::int64_t misses(std::int64_t loads) {
    carried_ += loads * (database_ - cached_);
    const std::int64_t of_law = carried_ / database_;
    carried_ %= database_;
    const std::int64_t of_cold = std::min(loads - of_law, cold_);
    cold_ -= of_cold;
    return of_law + of_cold;
  }

 private:
  static constexpr std::int64_t k_long_bytes = 4;

  std::int64_t cached_;
  std::int64_t database_;
  std::int64_t cold_;         // long words that have not been read yet
  std::int64_t carried_ = 0;  // of a miss, in parts of the database's size
};

}  // namespace maquette::models
