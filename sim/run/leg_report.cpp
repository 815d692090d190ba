#include "sim/run/leg_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "models/board/work_cost.hpp"
#include "sim/report/function_statistics.hpp"
#include "sim/run/calibration.hpp"
#include "sim/run/counted_source.hpp"

namespace maquette::sim {

namespace {

/// What legs of one stage, or intersections with one kind of primitive, come to.
struct LegSum {
  std::int64_t legs = 0;
  std::int64_t words_in = 0;
  std::int64_t words_out = 0;
  double clocks = 0;

  void add(const LegSum& other) {
    legs += other.legs;
    words_in += other.words_in;
    words_out += other.words_out;
    clocks += other.clocks;
  }
};

/// By stage and kind of primitive, which only intersections tell apart.
using LegSums = std::map<std::pair<models::Stage, int>, LegSum>;

double mean(double sum, std::int64_t of) { return of == 0 ? 0 : sum / static_cast<double>(of); }

std::string row(const std::string& name, const LegSum& sum, std::int64_t pixels, double clocks) {
  constexpr double k_percent = 100;
  const double share = clocks > 0 ? k_percent * sum.clocks / clocks : 0;
  return fmt::format("  {:<24} {:>10.2f} {:>9.1f} {:>9.1f} {:>11.0f} {:>8.1f} %\n", name,
                     mean(static_cast<double>(sum.legs), pixels),
                     mean(static_cast<double>(sum.words_in), sum.legs),
                     mean(static_cast<double>(sum.words_out), sum.legs), mean(sum.clocks, sum.legs),
                     share);
}

LegSums sums_of(CountedSource& source, const Machine& machine) {
  constexpr double k_milli = 1e-3;
  const models::WorkCost cost(machine.parameters.board);
  LegSums sums;
  const std::int64_t pixels = source.useful_zone().pixels();
  for (std::int64_t pixel = 0; pixel < pixels; ++pixel) {
    source.pixel(pixel);
    for (const models::PixelLeg& leg : source.legs()) {
      sums[{leg.stage, leg.primitive}].add(
          {1, leg.numbers_in, leg.numbers_out,
           k_milli * static_cast<double>(cost.milliclocks(leg.work))});
    }
  }
  return sums;
}

std::string table(const LegSums& sums, std::int64_t pixels) {
  LegSum whole;
  std::map<models::Stage, LegSum> stages;
  for (const auto& [of, sum] : sums) {
    whole.add(sum);
    stages[of.first].add(sum);
  }
  std::string text = fmt::format("  {:<24} {:>10} {:>9} {:>9} {:>11} {:>10}\n", "stage",
                                 "legs/pixel", "words in", "words out", "clocks/leg", "of clocks");
  for (const auto& [stage, sum] : stages) {
    text += row(models::k_stage_names[static_cast<std::size_t>(stage)], sum, pixels, whole.clocks);
    for (const auto& [of, part] : sums) {
      if (stage == models::Stage::intersection && of.first == stage) {
        text += row(function_name(firmware::k_fixed_function_count + of.second), part, pixels,
                    whole.clocks);
      }
    }
  }
  return text + row("all", whole, pixels, whole.clocks);
}

}  // namespace

std::string leg_report(const Scene& scene, const Machine& machine, int threads) {
  Machine without_units = machine;  // so that all legs are told apart
  without_units.parameters.units = {};
  CountedSource source(packed_scene<firmware::Counted>(scene, picture_format_of(machine)),
                       without_units, threads, LegsOfPixels::told);
  const Machine priced =
      is_calibrated(machine) ? with_costs(machine, calibrate(scene, machine)) : machine;
  const std::int64_t pixels = source.useful_zone().pixels();
  return fmt::format(
      "Legs of the process of {} pixels, at the costs of a board of {}\n"
      "(words of 32 bits, handed to and returned by whoever does a leg)\n{}",
      pixels, machine.name, table(sums_of(source, priced), pixels));
}

}  // namespace maquette::sim
