#include "models/board/pixel_meter.hpp"

#include <cstddef>

namespace maquette::models {

namespace {

/// The share of one of `parts`; the first ones take the ticks that are left.
Duration share(Duration whole, std::size_t parts, std::size_t part) {
  const auto count = static_cast<Duration::rep>(parts);
  const bool takes_rest = static_cast<Duration::rep>(part) < whole.count() % count;
  return whole / count + (takes_rest ? Duration(1) : Duration::zero());
}

}  // namespace

void PixelMeter::compute(const PixelPosition& position, const ProcessorTime& now) {
  computed_.push_back({position, board_, now - last_});
  last_ = now;
}

void PixelMeter::write(const ProcessorTime& now) {
  const ProcessorTime writing = now - last_;
  for (std::size_t i = 0; i < computed_.size(); ++i) {
    ProcessorTime& spent = computed_[i].spent;
    spent.compute += share(writing.compute, computed_.size(), i);
    spent.wait += share(writing.wait, computed_.size(), i);
    spent.transfer += share(writing.transfer, computed_.size(), i);
    observer_(computed_[i]);
  }
  computed_.clear();
  last_ = now;
}

}  // namespace maquette::models
