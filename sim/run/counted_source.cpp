#include "sim/run/counted_source.hpp"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include "sim/run/pixel_run.hpp"

namespace maquette::sim {

namespace {

/// Pixels that one thread synthesises in a row.
constexpr std::int64_t k_block_pixels = 64;

/// Blocks per thread that several threads make ready at once.
constexpr std::size_t k_blocks_ahead = 8;

}  // namespace

CountedSource::CountedSource(const PackedScene<firmware::Counted>& scene, const Machine& machine,
                             int threads, LegsOfPixels legs)
    : told_(legs),
      apart_(legs_apart_for(machine.parameters.units)),
      threads_(threads),
      arena_(threads),
      areas_([this] { return Area(frame().database); }) {
  firmware::reset_counted_work();
  scene_ = std::make_unique<PreparedScene<firmware::Counted>>(scene);
  preprocessing_ = firmware::counted_work();
  preprocessing_by_function_.add(firmware::counted_meter);
  const models::MachineParameters& parameters = machine.parameters;
  allotment_ = std::make_unique<models::PixelAllotment>(parameters.allotment, useful_zone(),
                                                        static_cast<int>(parameters.boards.size()));
  for (std::int64_t first = 0; first < allotment_->pixels(); first += k_block_pixels) {
    blocks_.push_back({{}, {}, std::min(k_block_pixels, allotment_->pixels() - first)});
  }
}

models::PixelRectangle CountedSource::useful_zone() const { return useful_zone_of(frame()); }

const models::SynthesizedPixel& CountedSource::pixel(std::int64_t index) {
  const auto number = static_cast<std::size_t>(index / k_block_pixels);
  Block& block = blocks_[number];
  if (block.left == 0) {
    throw std::logic_error("a pixel was taken twice");
  }
  if (block.waits()) {
    synthesise_from(number);
  }
  const auto place = static_cast<std::size_t>(index % k_block_pixels);
  taken_ = block.pixels[place];
  if (told_ == LegsOfPixels::told) {
    legs_ = std::move(block.legs[place]);
  }
  if (--block.left == 0) {
    freed_.push_back(std::move(block.pixels));
    block.pixels = {};
    block.legs = {};
  }
  return taken_;
}

void CountedSource::make_room(Block& block) {
  if (!freed_.empty()) {
    block.pixels = std::move(freed_.back());
    freed_.pop_back();
  }
  block.pixels.resize(static_cast<std::size_t>(block.left));
}

/// Makes a block ready; several threads share it and those after it that wait, one by one.
void CountedSource::synthesise_from(std::size_t first) {
  if (threads_ == 1) {
    make_room(blocks_[first]);
    synthesise(first);
    return;
  }
  std::vector<std::size_t> waiting;
  const std::size_t ahead = k_blocks_ahead * static_cast<std::size_t>(threads_);
  for (std::size_t block = first; block < blocks_.size() && waiting.size() < ahead; ++block) {
    if (blocks_[block].waits()) {
      make_room(blocks_[block]);
      waiting.push_back(block);
    }
  }
  // The library orders these threads as well, but out of sight of the thread sanitizer.
  std::atomic<std::size_t> done{0};
  done.store(0, std::memory_order_release);
  arena_.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, waiting.size(), 1),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        static_cast<void>(done.load(std::memory_order_acquire));
                        for (std::size_t i = range.begin(); i != range.end(); ++i) {
                          synthesise(waiting[i]);
                        }
                        done.fetch_add(range.size(), std::memory_order_release);
                      });
  });
  if (done.load(std::memory_order_acquire) != waiting.size()) {
    throw std::logic_error("a block of pixels was not synthesised");
  }
}

void CountedSource::synthesise(std::size_t block) {
  const firmware::WorkArea<firmware::Counted> view = areas_.local().view();
  PixelRun run(by_function_.local(), told_, apart_);
  std::int64_t index = static_cast<std::int64_t>(block) * k_block_pixels;
  for (models::SynthesizedPixel& synthesised : blocks_[block].pixels) {
    synthesised = run.pixel(frame(), view, allotment_->position(index++));
    if (told_ == LegsOfPixels::told) {
      blocks_[block].legs.push_back(run.legs());
    }
  }
}

FrameWork CountedSource::work_by_function() const {
  FrameWork work{preprocessing_by_function_, {}};
  for (const FunctionWork& of_thread : by_function_) {
    work.pixels.add(of_thread);
  }
  return work;
}

}  // namespace maquette::sim
