#pragma once

#include <optional>
#include <vector>

#include "sim/record/function_work.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/frame_source.hpp"
#include "sim/run/leg_teller.hpp"

namespace maquette::sim {

/// Pixels that one thread synthesises in a row; what they took by function is added to a sum when
/// the run ends. In between the thread may count nothing else.
class PixelRun {
 public:
  /// The sum is kept by reference. Legs that are told are so as LegTeller has it.
  PixelRun(FunctionWork& sum, LegsOfPixels legs, const LegsApart& apart = all_legs_apart())
      : sum_(sum) {
    firmware::reset_counted_work();
    if (legs == LegsOfPixels::told) {
      teller_.emplace(apart);
    }
  }
  PixelRun(const PixelRun&) = delete;
  PixelRun& operator=(const PixelRun&) = delete;
  PixelRun(PixelRun&&) = delete;
  PixelRun& operator=(PixelRun&&) = delete;
  ~PixelRun() {
    teller_.reset();  // which has some of the meter's cells while a pixel is not over
    sum_.add(firmware::counted_meter);
  }

  /// The next pixel.
  models::SynthesizedPixel pixel(const firmware::Frame<firmware::Counted>& frame,
                                 const firmware::WorkArea<firmware::Counted>& area,
                                 const models::PixelPosition& position) {
    if (teller_) {
      teller_->start();
    }
    models::SynthesizedPixel result = pixel_without_work(frame, area, position);
    if (teller_) {
      legs_ = &teller_->take();
    }
    firmware::LongWork since = firmware::counted_meter.sum();
    for (int i = 0; i < firmware::k_operation_count; ++i) {
      const std::uint64_t now = since.counts[i];
      since.counts[i] -= before_.counts[i];
      before_.counts[i] = now;
    }
    firmware::set_general_apart(since);
    result.work = firmware::narrowed(since);
    return result;
  }

  /// The legs of the last pixel, where they are told; valid until the next one.
  [[nodiscard]] const std::vector<models::PixelLeg>& legs() const { return *legs_; }

  /// Adds what was counted to the sum, so that the meter shows what comes next alone.
  void settle() {
    sum_.add(firmware::counted_meter);
    firmware::reset_counted_work();
    before_ = {};
  }

 private:
  FunctionWork& sum_;
  std::optional<LegTeller> teller_;
  const std::vector<models::PixelLeg>* legs_ = nullptr;  // the teller's
  firmware::LongWork before_{};
};

}  // namespace maquette::sim
