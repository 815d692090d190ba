#include "sim/accuracy/accuracy_report.hpp"

#include <fmt/format.h>

#include "sim/report/seconds.hpp"

namespace maquette::sim {

namespace {

std::string percent(const std::optional<double>& relative) {
  return relative ? fmt::format("{:+.3g} %", 100 * *relative) : "";
}

/// 'h' for the front of error and host time, 's' for that of error and simulated time.
std::string fronts_of(const LevelResult& level) {
  return std::string(level.is_on_host_front ? "h" : " ") + (level.is_on_simulated_front ? "s" : "");
}

std::string line_of(const std::string& name, const LevelResult& level) {
  const bool has_times = level.simulated.has_value();
  const bool has_errors = level.error.simulated.has_value();
  const PictureError& picture = level.error.picture;
  return fmt::format(
      "  {:<20}{:>9.3f} s  {:<3}{:>14}{:>12}{:>12}{:>12}{:>10.4g}{:>9}{:>9}\n", name,
      level.host.median_s, fronts_of(level),
      has_times ? readable_duration(level.simulated->frame) : "",
      has_errors ? percent(level.error.simulated->frame.relative) : "",
      has_errors ? fmt::format("{:+.3g}", in_seconds(level.error.simulated->worst_wait.absolute))
                 : "",
      has_errors ? percent(level.error.simulated->worst_wait.relative) : "", picture.mean,
      picture.largest, picture.pixels_off);
}

}  // namespace

std::string accuracy_report(const std::vector<LadderResult>& results) {
  std::string text = fmt::format("  {:<20}{:>11}  {:<3}{:>14}{:>12}{:>12}{:>12}{:>10}{:>9}{:>9}\n",
                                 "level", "host time", "on", "frame time", "error", "wait err s",
                                 "wait error", "levels", "largest", "pixels");
  for (const LadderResult& result : results) {
    text += fmt::format("{}: {}; reference: {}\n", result.ladder.name, result.ladder.varies,
                        result.ladder.reference_name());
    for (std::size_t i = 0; i < result.levels.size(); ++i) {
      text += line_of(result.ladder.levels[i].name, result.levels[i]);
    }
  }
  return text +
         "on: h on the Pareto front of error and host time, s of error and frame time; wait errors "
         "are those of the worst board;\nlevels: mean difference of the picture; pixels: off by "
         "more than one level. Host times are processor times and differ from run to run.\n";
}

}  // namespace maquette::sim
