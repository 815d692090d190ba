#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "models/bus/duration.hpp"

namespace maquette::models {

/// How often which wait occurred, in exponential buckets with linear sub-buckets: each power of two
/// is cut into 16 equal ones, so a bucket is at most 1/16 (6.25 %) of its lower edge wide; waits
/// below 32 ticks have a bucket each. Adding is a few instructions, and the order of the waits does
/// not matter.
class WaitHistogram {
 public:
  /// The waits of from <= wait < to.
  struct Bucket {
    Duration from;
    Duration to;
    std::int64_t count;
  };

  /// `wait` is not negative, and occurred so many times.
  void add(Duration wait, std::int64_t times = 1) {
    const std::size_t index = index_of(wait);
    if (index >= waits_.size()) {
      waits_.resize(index + 1);
    }
    waits_[index].count += times;
    waits_[index].longest = std::max(waits_[index].longest, wait);
  }

  void add(const WaitHistogram& other);

  [[nodiscard]] std::int64_t count() const;

  /// The nearest-rank quantile, the shortest wait that at least `per_mille` of 1000 waits do not
  /// exceed, rounded up to the longest wait in its bucket: so it is a wait that occurred, at most
  /// 1/16 above the exact one and never below it. 0 when there is no wait.
  [[nodiscard]] Duration quantile(int per_mille) const;

  /// Those that are not empty, from the shortest waits to the longest.
  [[nodiscard]] std::vector<Bucket> buckets() const;

 private:
  static std::size_t index_of(Duration wait);
  static Duration lower_edge(std::size_t index);

  struct Waits {
    std::int64_t count = 0;
    Duration longest{};
  };

  std::vector<Waits> waits_;
};

}  // namespace maquette::models
