#include "sim/accuracy/tile_times.hpp"

#include <numeric>

#include "models/board/work_cost.hpp"
#include "models/bus/checked_sum.hpp"
#include "models/display/pixel_format.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/executed_pixels.hpp"
#include "sim/run/interruption.hpp"
#include "sim/run/pixel_sample.hpp"

namespace maquette::sim {

namespace {

using CountedScene = PreparedScene<firmware::Counted>;

CountedScene prepared(const Scene& scene, const Machine& machine) {
  return CountedScene(packed_scene<firmware::Counted>(scene, picture_format_of(machine)));
}

TileTimes without_times(const CountedScene& scene) {
  const TileGrid grid{useful_zone_of(scene.frame())};
  return {grid, std::vector<models::Duration>(grid.count())};
}

std::uint32_t& pixel_at(const models::PixelPosition& position, models::Picture& picture) {
  return picture
      .pixels[static_cast<std::size_t>(position.row) * static_cast<std::size_t>(picture.width) +
              static_cast<std::size_t>(position.column)];
}

void add(models::Duration time, models::Duration& sum) { sum = models::checked_sum(sum, time); }

}  // namespace

models::Duration TileTimes::sum() const {
  return std::accumulate(times.begin(), times.end(), models::Duration::zero(), models::checked_sum);
}

TileTimes counted_tile_times(const Scene& scene, const Machine& machine, int share) {
  const CountedScene counted = prepared(scene, machine);
  SynthesisArea<firmware::Counted> area(counted.frame().database);
  const models::WorkCost cost(machine.parameters.board);
  TileTimes tiles = without_times(counted);
  const models::PixelRectangle& zone = tiles.grid.zone;
  for (const models::PixelPosition& position :
       pixels_of(pixel_sample(machine, zone, share), zone)) {
    add(cost.duration(counted_pixel(counted.frame(), area.view(), position).work),
        tiles.times[tiles.grid.number_at(position)]);
  }
  return tiles;
}

TileTimes executed_tile_times(const Scene& scene, const Machine& machine, int share,
                              models::Picture& picture) {
  const models::PixelFormat format(machine.parameters.frame_memory);
  TileTimes tiles = without_times(prepared(scene, machine));
  execute_pixels(scene, machine, share, [&](const ExecutedPixel& pixel) {
    add(pixel.time, tiles.times[tiles.grid.number_at(pixel.position)]);
    pixel_at(pixel.position, picture) = format.colour(pixel.bytes & format.kept());
    return !Interruption::is_requested();
  });
  return tiles;
}

}  // namespace maquette::sim
