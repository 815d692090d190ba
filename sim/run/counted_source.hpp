#pragma once

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/task_arena.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "models/board/allotment.hpp"
#include "models/unit/pixel_leg.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/machine/machine.hpp"
#include "sim/run/frame_source.hpp"
#include "sim/run/leg_teller.hpp"

namespace maquette::sim {

/// Pixels from the native firmware, which counts its work. With several host threads it synthesises
/// ahead of simulated time; pixels do not depend on one another, so their number changes nothing.
/// Of the legs those are apart that units of the machine do. Pixels and their legs are kept from
/// when their block is synthesised until they are taken.
class CountedSource : public FrameSource, public models::LegSource {
 public:
  /// `threads` is at least 1.
  CountedSource(const PackedScene<firmware::Counted>& scene, const Machine& machine, int threads,
                LegsOfPixels legs = LegsOfPixels::untold);

  const models::SynthesizedPixel& pixel(std::int64_t index) override;
  [[nodiscard]] firmware::Work preprocessing() const override { return preprocessing_; }
  [[nodiscard]] FrameWork work_by_function() const override;
  /// None where they are untold.
  [[nodiscard]] const std::vector<models::PixelLeg>& legs() override { return legs_; }

  [[nodiscard]] models::PixelRectangle useful_zone() const;
  [[nodiscard]] const firmware::Frame<firmware::Counted>& frame() const { return scene_->frame(); }

 private:
  using Area = SynthesisArea<firmware::Counted>;

  /// Pixels of consecutive indices: not yet synthesised, ready, or all taken and freed.
  struct Block {
    std::vector<models::SynthesizedPixel> pixels;
    std::vector<std::vector<models::PixelLeg>> legs;  ///< of each, where they are told
    std::int64_t left;                                ///< not yet taken

    [[nodiscard]] bool waits() const { return pixels.empty() && left > 0; }
  };

  void make_room(Block& block);
  void synthesise_from(std::size_t first);
  void synthesise(std::size_t block);

  firmware::Work preprocessing_{};
  FunctionWork preprocessing_by_function_;
  std::unique_ptr<PreparedScene<firmware::Counted>> scene_;
  std::unique_ptr<models::PixelAllotment> allotment_;
  std::vector<Block> blocks_;
  std::vector<std::vector<models::SynthesizedPixel>> freed_;  // memory of blocks, to be used again
  models::SynthesizedPixel taken_{};  // the last one, whose block may be freed
  std::vector<models::PixelLeg> legs_;
  LegsOfPixels told_;
  LegsApart apart_;
  int threads_;
  tbb::task_arena arena_;
  tbb::enumerable_thread_specific<Area> areas_;
  tbb::enumerable_thread_specific<FunctionWork> by_function_;
};

}  // namespace maquette::sim
