#include "sim/run/calibration.hpp"

#include <algorithm>
#include <cmath>

#include "models/board/work_cost.hpp"
#include "sim/database/prepared_scene.hpp"
#include "sim/run/counted_pixel.hpp"
#include "sim/run/executed_pixels.hpp"

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

firmware::Work counted(const PreparedScene<firmware::Counted>& scene,
                       SynthesisArea<firmware::Counted>& area,
                       const models::PixelPosition& position) {
  firmware::reset_counted_work();
  firmware::synthesize(scene.frame(), area.view(), static_cast<std::int16_t>(position.column),
                       static_cast<std::int16_t>(position.row));
  return firmware::counted_work();
}

/// How long a thousandth of a clock lasts, refresh included, in picoseconds.
double milliclock_ps(const Machine& machine) {
  constexpr std::int64_t k_many = 1'000'000'000'000;
  const models::WorkCost cost(machine.parameters.board);
  return static_cast<double>(cost.elapsed(k_many).count()) / static_cast<double>(k_many);
}

std::vector<PricedWork> samples_of(const Scene& scene, const Machine& machine) {
  const PreparedScene<firmware::Counted> prepared(
      packed_scene<firmware::Counted>(scene, picture_format_of(machine)));
  SynthesisArea<firmware::Counted> area(prepared.frame().database);
  const std::int64_t share = useful_zone_of(prepared.frame()).pixels() / k_wanted_pixels;
  const double milliclock = milliclock_ps(machine);
  std::vector<PricedWork> samples;
  execute_pixels(scene, machine, static_cast<int>(std::max<std::int64_t>(1, share)),
                 [&](const ExecutedPixel& pixel) {
                   samples.push_back({counted(prepared, area, pixel.position),
                                      static_cast<double>(pixel.time.count()) / milliclock});
                   return true;
                 });
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
  const std::vector<PricedWork> samples = samples_of(scene, machine);
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
