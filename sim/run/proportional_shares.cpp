#include "sim/run/proportional_shares.hpp"

#include <algorithm>
#include <numeric>

namespace maquette::sim {

namespace {

/// Products with a time stay within 128 bits below it.
constexpr models::Wide k_largest_sum = models::Wide{1} << 62U;

models::Wide sum_of(const std::vector<models::Wide>& weights) {
  return std::accumulate(weights.begin(), weights.end(), models::Wide{0});
}

}  // namespace

std::vector<models::Duration> proportional_shares(models::Duration total,
                                                  std::vector<models::Wide> weights) {
  models::Wide sum = sum_of(weights);
  while (sum > k_largest_sum) {
    for (models::Wide& weight : weights) {
      weight /= 2;
    }
    sum = sum_of(weights);
  }
  std::vector<models::Duration> shares(weights.size());
  if (sum == 0) {
    return shares;
  }
  std::vector<models::Wide> remainders;
  models::Duration left = total;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    const models::Wide product = weights[i] * total.count();
    shares[i] = models::Duration(static_cast<models::Duration::rep>(product / sum));
    remainders.push_back(product % sum);
    left -= shares[i];
  }
  std::vector<std::size_t> order(weights.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&remainders](std::size_t a, std::size_t b) {
    return remainders[a] > remainders[b];
  });
  for (std::size_t i = 0; left > models::Duration::zero(); ++i) {
    shares[order[i]] += models::Duration(1);
    left -= models::Duration(1);
  }
  return shares;
}

}  // namespace maquette::sim
