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

std::string percent_of(double share) { return fmt::format("{:.3g} %", 100 * share); }

/// Of the boards' processors, simulated in a second of the host.
std::string rate_of(const LevelResult& level) {
  return level.simulated && level.host.median_s > 0
             ? fmt::format("{:.0f}", level.simulated->processor_clocks / level.host.median_s / 1e6)
             : "";
}

std::string line_of(const std::string& name, const LevelResult& level) {
  const bool has_errors = level.error.simulated.has_value();
  const std::optional<TimeError> wait =
      has_errors ? level.error.simulated->worst_wait : std::nullopt;
  const PictureError& picture = level.error.picture;
  return fmt::format("  {:<20}{:>9.3f} s{:>10}  {:<3}{:>14}{:>12}{:>12}{:>12}{:>10.4g}{:>9}{:>9}\n",
                     name, level.host.median_s, rate_of(level), fronts_of(level),
                     level.simulated ? readable_duration(level.simulated->frame) : "",
                     has_errors ? percent(level.error.simulated->frame.relative) : "",
                     wait ? fmt::format("{:+.3g}", in_seconds(wait->absolute)) : "",
                     wait ? percent(wait->relative) : "", picture.mean, picture.largest,
                     picture.pixels_off);
}

/// What follows the lines of a ladder's levels that time tiles.
std::string tile_lines_of(const LadderResult& result) {
  std::string text;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    if (const std::optional<TileError>& tiles = result.levels[i].error.tiles;
        tiles && i != result.ladder.reference) {
      text += fmt::format(
          "  {:<20}time per tile of 16 x 16 pixels: off by {} (median), {} (95 % of the tiles), {} "
          "(worst)\n",
          result.ladder.levels[i].name, percent_of(tiles->median), percent_of(tiles->most_of_95),
          percent_of(tiles->worst));
    }
  }
  return text;
}

}  // namespace

std::string accuracy_report(const std::vector<LadderResult>& results) {
  std::string text =
      fmt::format("  {:<20}{:>11}{:>10}  {:<3}{:>14}{:>12}{:>12}{:>12}{:>10}{:>9}{:>9}\n", "level",
                  "host time", "MHz", "on", "frame time", "error", "wait err s", "wait error",
                  "levels", "largest", "pixels");
  for (const LadderResult& result : results) {
    text += fmt::format("{}: {}; reference: {}\n", result.ladder.name, result.ladder.varies,
                        result.ladder.reference_name());
    for (std::size_t i = 0; i < result.levels.size(); ++i) {
      text += line_of(result.ladder.levels[i].name, result.levels[i]);
    }
    text += tile_lines_of(result);
  }
  return text +
         "MHz: clocks of the boards' processors, all together, simulated in a second of the host; "
         "on: h on the Pareto front of error and host time, s of error and frame time; wait errors "
         "are those of the worst board;\nlevels: mean difference of the picture; pixels: off by "
         "more than one level. Host times are processor times and differ from run to run.\n";
}

}  // namespace maquette::sim
