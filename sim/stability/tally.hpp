#pragma once

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_reduce.h>

namespace maquette::sim {

/// What `add(number, tally)` adds up over the cases 0 .. cases - 1, on all processors. A tally
/// starts as `Tally{}` and is joined by `+=`, which must not depend on the order: counts and
/// maxima.
template <class Tally, class Add>
Tally tally_over(int cases, const Add& add) {
  return tbb::parallel_reduce(
      tbb::blocked_range<int>(0, cases), Tally{},
      [&add](const tbb::blocked_range<int>& range, Tally tally) {
        for (int number = range.begin(); number != range.end(); ++number) {
          add(number, tally);
        }
        return tally;
      },
      [](Tally sum, const Tally& other) {
        sum += other;
        return sum;
      });
}

}  // namespace maquette::sim
