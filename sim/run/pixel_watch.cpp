#include "sim/run/pixel_watch.hpp"

namespace maquette::sim {

namespace {

std::size_t place_in(const models::PixelRectangle& zone, int column, int row) {
  return static_cast<std::size_t>(row - zone.row0) * static_cast<std::size_t>(zone.width) +
         static_cast<std::size_t>(column - zone.column0);
}

}  // namespace

void watch_pixels(models::CcettMachine& model, PixelFacts& facts) {
  const auto pixels = static_cast<std::size_t>(facts.zone.pixels());
  facts.times.resize(pixels);
  facts.written.assign(pixels, models::k_never);
  model.observe_pixels([&facts](const models::PixelTime& pixel) {
    facts.times[place_in(facts.zone, pixel.position.column, pixel.position.row)] = pixel;
  });
}

void tell_instants(const models::CcettMachine& model, PixelFacts& facts) {
  const models::Duration start = model.statistics().load_time;
  for (const models::PixelWriteRecord& write : model.frame_memory().log()) {
    const int column = static_cast<int>(write.pixel) % facts.width;
    const int row = static_cast<int>(write.pixel) / facts.width;
    facts.written[place_in(facts.zone, column, row)] = write.instant - start;
  }
}

}  // namespace maquette::sim
