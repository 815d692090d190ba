#pragma once

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/task_arena.h>

#include <memory>
#include <vector>

#include "firmware/counted.hpp"
#include "models/allotment.hpp"
#include "models/pixel_source.hpp"
#include "sim/description/machine.hpp"
#include "sim/scene/prepared_scene.hpp"

namespace maquette::sim {

/// Pixels from the native firmware, which counts its work. With several host threads it synthesises
/// ahead of simulated time; pixels do not depend on one another, so their number changes nothing.
class CountedSource : public models::PixelSource {
 public:
  /// `threads` is at least 1.
  CountedSource(const PackedScene<firmware::Counted>& scene, const Machine& machine, int threads);

  const models::SynthesizedPixel* next(int board) override;
  [[nodiscard]] firmware::Work preprocessing() const override { return preprocessing_; }

  [[nodiscard]] models::PixelRectangle useful_zone() const;
  [[nodiscard]] const firmware::Frame<firmware::Counted>& frame() const { return scene_->frame(); }

  /// Share of the pixels that the boards have taken, 0 to 1.
  [[nodiscard]] double fraction_taken() const;

 private:
  using Area = SynthesisArea<firmware::Counted>;

  /// Pixels of a board that are ready, and where it stands in its allotment.
  struct Queue {
    std::vector<models::SynthesizedPixel> pixels;
    std::size_t next = 0;    ///< in `pixels`
    std::int64_t first = 0;  ///< number of the first of `pixels` in the board's allotment
    std::int64_t count = 0;  ///< of the whole allotment

    [[nodiscard]] std::int64_t left() const {
      return count - first - static_cast<std::int64_t>(pixels.size());
    }
  };

  void refill(int board);
  void refill_all();
  void synthesise(int board, std::size_t begin, std::size_t end, Area& area);

  firmware::Work preprocessing_{};
  std::unique_ptr<PreparedScene<firmware::Counted>> scene_;
  std::unique_ptr<models::PixelAllotment> allotment_;
  std::vector<Queue> queues_;
  std::int64_t taken_ = 0;
  int threads_;
  tbb::task_arena arena_;
  tbb::enumerable_thread_specific<Area> areas_;
};

}  // namespace maquette::sim
