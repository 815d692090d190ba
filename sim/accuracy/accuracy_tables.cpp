#include "sim/accuracy/accuracy_tables.hpp"

#include <fmt/format.h>

#include <numeric>

#include "sim/report/seconds.hpp"

namespace maquette::sim {

namespace {

models::Duration mean_of(const std::vector<models::Duration>& times) {
  const models::Duration sum =
      std::accumulate(times.begin(), times.end(), models::Duration::zero());
  return times.empty() ? sum : sum / static_cast<models::Duration::rep>(times.size());
}

std::string relative_cell(const std::optional<double>& relative) {
  return relative ? fmt::format("{}", *relative) : "";
}

std::vector<std::string> time_cells(const LevelResult& level) {
  if (!level.simulated) {
    return {"", "", "", "", ""};
  }
  const std::vector<models::Duration>& waits = level.simulated->waits;
  std::vector<std::string> cells = {format_seconds(level.simulated->frame), "",
                                    waits.empty() ? "" : format_seconds(mean_of(waits)), "", ""};
  if (level.error.simulated) {
    cells[1] = relative_cell(level.error.simulated->frame.relative);
    if (const std::optional<TimeError>& worst = level.error.simulated->worst_wait) {
      cells[3] = format_seconds(worst->absolute);
      cells[4] = relative_cell(worst->relative);
    }
  }
  return cells;
}

std::vector<std::string> tile_cells(const std::optional<TileError>& tiles) {
  if (!tiles) {
    return {"", "", ""};
  }
  return {fmt::format("{}", tiles->median), fmt::format("{}", tiles->most_of_95),
          fmt::format("{}", tiles->worst)};
}

/// Of the boards' processors, simulated in a second of the host.
std::string rate_cell(const LevelResult& level) {
  return level.simulated && level.host.median_s > 0
             ? fmt::format("{:.4g}", level.simulated->processor_clocks / level.host.median_s)
             : "";
}

std::string mark_of(bool is_on_front) { return is_on_front ? "front" : ""; }

/// Calls `add` with each ladder's result and each of its levels' numbers.
template <class Add>
void for_each_level(const std::vector<LadderResult>& results, Add add) {
  for (const LadderResult& result : results) {
    for (std::size_t level = 0; level < result.levels.size(); ++level) {
      add(result.ladder, result.ladder.levels[level].name, result.levels[level]);
    }
  }
}

}  // namespace

Table error_table(const std::vector<LadderResult>& results) {
  Table table{{{"ladder", "", ""},
               {"level", "", ""},
               {"reference", "", "level that it is held against"},
               {"frame_time_s", "s", "simulated"},
               {"frame_time_error", "1", "relative"},
               {"wait_s", "s", "for grants of the bus, mean of the boards"},
               {"wait_error_s", "s", "of the board where it is largest"},
               {"wait_error", "1", "the same, relative"},
               {"tile_error_median", "1", "of the time per tile of 16 x 16 pixels, without sign"},
               {"tile_error_95", "1", "not exceeded by 95 % of the tiles"},
               {"tile_error_worst", "1", "full red or blue in tile_error.png"},
               {"picture_largest", "levels", "largest difference of a channel"},
               {"picture_mean", "levels", "mean difference"},
               {"pixels_off", "pixels", "by more than one level"},
               {"error", "", "that the ladder is judged by"},
               {"simulated_front", "", "on the Pareto front of error and frame time"}},
              {}};
  for_each_level(
      results, [&table](const Ladder& ladder, const std::string& name, const LevelResult& level) {
        std::vector<std::string> row = {ladder.name, name, ladder.reference_name()};
        const std::vector<std::string> times = time_cells(level);
        row.insert(row.end(), times.begin(), times.end());
        const std::vector<std::string> tiles = tile_cells(level.error.tiles);
        row.insert(row.end(), tiles.begin(), tiles.end());
        const PictureError& picture = level.error.picture;
        row.insert(row.end(),
                   {fmt::format("{}", picture.largest), fmt::format("{}", picture.mean),
                    fmt::format("{}", picture.pixels_off), fmt::format("{}", level.magnitude),
                    mark_of(level.is_on_simulated_front)});
        table.rows.push_back(std::move(row));
      });
  return table;
}

Table host_time_table(const std::vector<LadderResult>& results) {
  Table table{{{"ladder", "", ""},
               {"level", "", ""},
               {"host_time_s", "s", "processor time of one thread, median"},
               {"host_time_least_s", "s", ""},
               {"host_time_most_s", "s", ""},
               {"repeats", "", ""},
               {"cycles_per_host_second", "1/s", "clocks of all boards, simulated"},
               {"error", "", "that the ladder is judged by"},
               {"host_front", "", "on the Pareto front of error and host time"}},
              {}};
  for_each_level(
      results, [&table](const Ladder& ladder, const std::string& name, const LevelResult& level) {
        table.rows.push_back({ladder.name, name, fmt::format("{:.4f}", level.host.median_s),
                              fmt::format("{:.4f}", level.host.least_s),
                              fmt::format("{:.4f}", level.host.most_s),
                              fmt::format("{}", level.host.repeats), rate_cell(level),
                              fmt::format("{}", level.magnitude), mark_of(level.is_on_host_front)});
      });
  return table;
}

}  // namespace maquette::sim
