#include "sim/run/calibration.hpp"

#include <algorithm>
#include <cmath>

#include "models/board/work_cost.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/executed_sample.hpp"

namespace maquette::sim {

namespace {

/// Pixels that are executed for a frame; a few more than the classes of operations, times thirty.
constexpr std::int64_t k_wanted_pixels = 780;

/// The table's own prices, calls of the package without overhead.
Prices table_prices(const Machine& machine) {
  models::Kvm02Parameters board = machine.parameters.board;
  board.call_overhead = {};
  const models::WorkCost table(board);
  Prices prices{};
  for (std::size_t i = 0; i < prices.size(); ++i) {
    prices[i] = static_cast<double>(table.milliclocks(static_cast<firmware::Operation>(i)));
  }
  return prices;
}

/// Steps through the zone's rows that are no divisor of their length, so that samples form no
/// columns.
std::uint32_t step_through(const models::PixelRectangle& zone) {
  std::int64_t step = std::max<std::int64_t>(1, zone.pixels() / k_wanted_pixels);
  while (step > 1 && (zone.width % step == 0 || step % 2 == 0)) {
    ++step;
  }
  return static_cast<std::uint32_t>(step);
}

firmware::Work counted(const PreparedScene<firmware::Counted>& scene,
                       SynthesisArea<firmware::Counted>& area, const ExecutedPixel& pixel) {
  firmware::reset_counted_work();
  firmware::synthesize(scene.frame(), area.view(), static_cast<std::int16_t>(pixel.column),
                       static_cast<std::int16_t>(pixel.row));
  return firmware::counted_work();
}

std::vector<PricedWork> samples_of(const Scene& scene, const Machine& machine,
                                   const Prices& table) {
  const PictureFormat format = picture_format_of(machine);
  const PreparedScene<firmware::Counted> prepared(packed_scene<firmware::Counted>(scene, format));
  SynthesisArea<firmware::Counted> area(prepared.frame().database);
  const std::uint32_t step = step_through(useful_zone_of(prepared.frame()));
  std::vector<PricedWork> samples;
  for (const ExecutedPixel& pixel :
       executed_sample(packed_scene<float>(scene, format), machine, step)) {
    const double arithmetic = cost(pixel.arithmetic, table);
    samples.push_back(
        {counted(prepared, area, pixel), static_cast<double>(pixel.milliclocks) + arithmetic});
  }
  return samples;
}

void judge(const std::vector<PricedWork>& samples, Calibration& calibration) {
  double sum = 0;
  double difference = 0;
  double squares = 0;
  for (const PricedWork& sample : samples) {
    const double error = cost(sample.work, calibration.milliclocks) - sample.milliclocks;
    sum += sample.milliclocks;
    difference += error;
    squares += error * error;
  }
  const auto count = static_cast<double>(samples.size());
  calibration.pixels = static_cast<int>(samples.size());
  calibration.sum_error = sum == 0 ? 0 : difference / sum;
  calibration.typical_error = sum == 0 ? 0 : std::sqrt(squares / count) / (sum / count);
}

}  // namespace

Calibration calibrate(const Scene& scene, const Machine& machine) {
  const Prices table = table_prices(machine);
  const std::vector<PricedWork> samples = samples_of(scene, machine, table);
  Calibration calibration{};
  calibration.milliclocks = fitted_prices(samples, table);
  judge(samples, calibration);
  return calibration;
}

Machine with_prices(const Machine& machine, const Prices& milliclocks) {
  constexpr double k_milli = 1e3;
  Machine priced = machine;
  models::ArithmeticCosts& costs = priced.parameters.board.arithmetic;
  for (std::size_t i = 0; i < milliclocks.size(); ++i) {
    costs.operations[i] = {milliclocks[i] / k_milli, 0, 0};
    costs.called[i] = false;
  }
  return priced;
}

}  // namespace maquette::sim
