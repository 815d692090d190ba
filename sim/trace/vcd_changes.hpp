#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "models/bus/instant.hpp"
#include "sim/trace/vcd_dump.hpp"

namespace maquette::sim {

/// What tells a dump of changes, some at a time.
struct ChangeSource {
  models::Instant next;  ///< none that are still to be told come before it; never: there are none
  std::function<models::Instant()> tell;  ///< tells the next ones; what `next` is then
};

/// Tells of each item of a list, in its order, which is that of their `from`. Keeps the list by
/// reference.
template <class Items, class Tell>
ChangeSource source_of(const Items& items, Tell tell) {
  const auto next = [&items](std::size_t i) {
    return i < items.size() ? items[i].from : models::k_never;
  };
  return {next(0), [&items, next, tell, i = std::size_t{0}]() mutable {
            tell(items[i++]);
            return next(i);
          }};
}

/// The changes of a dump in the order of time, of which only those are held that may not be the
/// next.
class ChangesInOrder {
 public:
  ChangesInOrder(VcdDump& dump, std::vector<ChangeSource> sources)
      : dump_(dump), sources_(std::move(sources)) {
    std::make_heap(sources_.begin(), sources_.end(), is_later);
    settle();
  }

  [[nodiscard]] bool has_before(models::Instant at) const { return dump_.has_before(at); }
  [[nodiscard]] bool has_at_most(models::Instant at) const {
    return dump_.has_before(at + models::Duration(1));
  }

  SignalChange take() {
    const SignalChange change = dump_.take();
    settle();
    return change;
  }

 private:
  static bool is_later(const ChangeSource& a, const ChangeSource& b) { return a.next > b.next; }

  /// Lets sources tell until none has anything before the next change.
  void settle() {
    while (!sources_.empty() && !dump_.has_before(sources_.front().next)) {
      std::pop_heap(sources_.begin(), sources_.end(), is_later);
      ChangeSource& source = sources_.back();
      if (source.next == models::k_never) {
        sources_.pop_back();
        continue;
      }
      source.next = source.tell();
      std::push_heap(sources_.begin(), sources_.end(), is_later);
    }
  }

  VcdDump& dump_;
  std::vector<ChangeSource> sources_;  // a heap, the earliest first
};

}  // namespace maquette::sim
