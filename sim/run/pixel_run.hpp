#pragma once

#include "sim/record/function_work.hpp"
#include "sim/run/counted_pixel.hpp"

namespace maquette::sim {

/// Pixels that one thread synthesises in a row; what they took by function is added to a sum when
/// the run ends. In between the thread may count nothing else.
class PixelRun {
 public:
  /// The sum is kept by reference.
  explicit PixelRun(FunctionWork& sum) : sum_(sum) { firmware::reset_counted_work(); }
  PixelRun(const PixelRun&) = delete;
  PixelRun& operator=(const PixelRun&) = delete;
  PixelRun(PixelRun&&) = delete;
  PixelRun& operator=(PixelRun&&) = delete;
  ~PixelRun() { sum_.add(firmware::counted_meter); }

  /// The next pixel.
  models::SynthesizedPixel pixel(const firmware::Frame<firmware::Counted>& frame,
                                 const firmware::WorkArea<firmware::Counted>& area,
                                 const models::PixelPosition& position) {
    models::SynthesizedPixel result = pixel_without_work(frame, area, position);
    const firmware::LongWork now = firmware::long_counted_work();
    firmware::LongWork since{};
    for (int i = 0; i < firmware::k_operation_count; ++i) {
      since.counts[i] = now.counts[i] - before_.counts[i];
    }
    before_ = now;
    result.work = firmware::narrowed(since);
    return result;
  }

  /// Adds what was counted to the sum, so that the meter shows what comes next alone.
  void settle() {
    sum_.add(firmware::counted_meter);
    firmware::reset_counted_work();
    before_ = {};
  }

 private:
  FunctionWork& sum_;
  firmware::LongWork before_{};
};

}  // namespace maquette::sim
