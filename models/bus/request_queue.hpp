#pragma once

#include <algorithm>
#include <vector>

#include "models/bus/arbitration.hpp"

namespace maquette::models {

/// The requests that stand or will stand on a bus, in the order of their instants; at most one per
/// master. A handful of masters makes a sorted array the fastest queue.
class RequestQueue {
 public:
  void insert(const Contender& contender) {
    const auto after = std::find_if(
        requests_.rbegin(), requests_.rend(),
        [&contender](const Contender& other) { return other.request <= contender.request; });
    requests_.insert(after.base(), contender);
  }

  void remove(int master) { requests_.erase(find(master)); }

  /// That of a master that stands.
  [[nodiscard]] const Contender& of(int master) const { return *find(master); }

  /// Of a master; k_never when it does not stand.
  [[nodiscard]] Instant request_of(int master) const {
    const auto found = find(master);
    return found == requests_.end() ? k_never : found->request;
  }

  [[nodiscard]] Instant earliest() const {
    return requests_.empty() ? k_never : requests_.front().request;
  }

  /// Those of at most `instant`.
  [[nodiscard]] Contenders up_to(Instant instant) const {
    const Contender* last = requests_.data();
    const Contender* const end = last + requests_.size();
    while (last != end && last->request <= instant) {
      ++last;
    }
    return {requests_.data(), last};
  }

 private:
  [[nodiscard]] std::vector<Contender>::const_iterator find(int master) const {
    return std::find_if(requests_.begin(), requests_.end(),
                        [master](const Contender& one) { return one.master == master; });
  }

  std::vector<Contender> requests_;
};

}  // namespace maquette::models
