#include "sim/accuracy/ladder_result.hpp"

#include <algorithm>

#include "sim/accuracy/pareto_front.hpp"
#include "sim/report/quantile.hpp"
#include "sim/report/seconds.hpp"

namespace maquette::sim {

namespace {

void mark_host_front(LadderResult& result) {
  std::vector<Tradeoff> points;
  for (const LevelResult& level : result.levels) {
    points.push_back({level.host.median_s, level.magnitude});
  }
  const std::vector<bool> front = pareto_front(points);
  for (std::size_t i = 0; i < front.size(); ++i) {
    result.levels[i].is_on_host_front = front[i];
  }
}

void mark_simulated_front(LadderResult& result) {
  std::vector<Tradeoff> points;
  for (const LevelResult& level : result.levels) {
    if (!is_apart_from_time(result.ladder.measure) || !level.simulated) {
      return;
    }
    points.push_back({in_seconds(level.simulated->frame), level.magnitude});
  }
  const std::vector<bool> front = pareto_front(points);
  for (std::size_t i = 0; i < front.size(); ++i) {
    result.levels[i].is_on_simulated_front = front[i];
  }
}

}  // namespace

HostTimes host_times_of(std::vector<double> times_s) {
  std::sort(times_s.begin(), times_s.end());
  return {quantile(times_s, 0.5), times_s.front(), times_s.back(),
          static_cast<int>(times_s.size())};
}

LadderResult result_of(const Ladder& ladder,
                       const std::vector<std::vector<LevelOutcome>>& outcomes) {
  LadderResult result{ladder, {}};
  const LevelOutcome& reference = outcomes[ladder.reference].front();
  for (const std::vector<LevelOutcome>& repeats : outcomes) {
    std::vector<double> times_s;
    times_s.reserve(repeats.size());
    for (const LevelOutcome& outcome : repeats) {
      times_s.push_back(outcome.host_time_s);
    }
    LevelResult level;
    level.simulated = repeats.front().simulated;
    level.error = error_of(repeats.front(), reference);
    level.magnitude = magnitude_of(level.error, ladder.measure);
    level.host = host_times_of(std::move(times_s));
    result.levels.push_back(std::move(level));
  }
  mark_host_front(result);
  mark_simulated_front(result);
  return result;
}

}  // namespace maquette::sim
