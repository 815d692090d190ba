#include "sim/run/program_samples.hpp"

#include <algorithm>

#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/executed_pixels.hpp"
#include "sim/run/execution_check.hpp"

namespace maquette::sim {

namespace {

/// Pixels that are executed for a frame: some twenty for each class of operations.
constexpr std::int64_t k_wanted_pixels = 780;

}  // namespace

Machine sample_machine(const Machine& machine) {
  Machine sample = board_alone(machine);
  sample.parameters.allotment = {};
  sample.parameters.board.database = models::DatabasePlace::own_copy;
  sample.parameters.bus.data_width_bits = models::VersaBusParameters{}.data_width_bits;
  return sample;
}

std::vector<CostSample> program_samples(const Scene& scene, const Machine& machine) {
  Scene executed = scene;
  executed.extents.reset();  // the program compares with all
  const PreparedScene<firmware::Counted> prepared(
      packed_scene<firmware::Counted>(executed, picture_format_of(machine)));
  SynthesisArea<firmware::Counted> area(prepared.frame().database);
  const std::int64_t share = useful_zone_of(prepared.frame()).pixels() / k_wanted_pixels;
  std::vector<CostSample> samples;
  execute_pixels(
      scene, sample_machine(machine), static_cast<int>(std::max<std::int64_t>(1, share)),
      [&](const ExecutedPixel& pixel) {
        samples.push_back(
            {counted_pixel(prepared.frame(), area.view(), pixel.position).work, pixel.program});
        return true;
      });
  return samples;
}

}  // namespace maquette::sim
