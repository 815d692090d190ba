#include "models/bus/wait_histogram.hpp"

#include <numeric>

namespace maquette::models {

namespace {

constexpr unsigned k_sub_bucket_bits = 4;
constexpr std::uint64_t k_sub_buckets = 1U << k_sub_bucket_bits;
constexpr std::int64_t k_per_mille = 1000;

unsigned highest_bit(std::uint64_t value) {
  return 63U - static_cast<unsigned>(__builtin_clzll(value));
}

}  // namespace

// With s sub-buckets per power of two, a value below 2s is its own index. A larger one is shifted
// into [s, 2s[; each bit of the shift goes s indices further.
std::size_t WaitHistogram::index_of(Duration wait) {
  const auto value = static_cast<std::uint64_t>(wait.count());
  if (value < 2 * k_sub_buckets) {
    return value;
  }
  const unsigned shift = highest_bit(value) - k_sub_bucket_bits;
  return shift * k_sub_buckets + (value >> shift);
}

Duration WaitHistogram::lower_edge(std::size_t index) {
  if (index < 2 * k_sub_buckets) {
    return Duration(static_cast<std::int64_t>(index));
  }
  const auto shift = static_cast<unsigned>(index / k_sub_buckets - 1);
  return Duration(static_cast<std::int64_t>((index - shift * k_sub_buckets) << shift));
}

void WaitHistogram::add(const WaitHistogram& other) {
  waits_.resize(std::max(waits_.size(), other.waits_.size()));
  for (std::size_t index = 0; index < other.waits_.size(); ++index) {
    waits_[index].count += other.waits_[index].count;
    waits_[index].longest = std::max(waits_[index].longest, other.waits_[index].longest);
  }
}

std::int64_t WaitHistogram::count() const {
  return std::accumulate(waits_.begin(), waits_.end(), std::int64_t{0},
                         [](std::int64_t sum, const Waits& waits) { return sum + waits.count; });
}

Duration WaitHistogram::quantile(int per_mille) const {
  const std::int64_t rank = (count() * per_mille + k_per_mille - 1) / k_per_mille;
  std::int64_t reached = 0;
  for (const Waits& waits : waits_) {
    reached += waits.count;
    if (waits.count > 0 && reached >= rank) {
      return waits.longest;
    }
  }
  return Duration::zero();
}

std::vector<WaitHistogram::Bucket> WaitHistogram::buckets() const {
  std::vector<Bucket> buckets;
  for (std::size_t index = 0; index < waits_.size(); ++index) {
    if (waits_[index].count > 0) {
      buckets.push_back({lower_edge(index), lower_edge(index + 1), waits_[index].count});
    }
  }
  return buckets;
}

}  // namespace maquette::models
