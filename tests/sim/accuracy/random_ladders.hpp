#pragma once

#include <random>
#include <string>
#include <vector>

#include "sim/accuracy/ladder_result.hpp"

namespace maquette::tests {

/// An outcome with two boards, or without a machine, over a picture of a few pixels.
inline sim::LevelOutcome random_outcome(std::mt19937& random, bool is_simulated) {
  sim::LevelOutcome outcome;
  outcome.picture = {5, 3, {}};
  for (int i = 0; i < 15; ++i) {
    outcome.picture.pixels.push_back(static_cast<std::uint32_t>(random() % 4) * 0x010101U);
  }
  if (is_simulated) {
    const auto time = [&random] {
      return models::Duration{static_cast<std::int64_t>(random()) * 100'003};
    };
    outcome.simulated = {time(), {time(), time()}, static_cast<double>(random())};
    outcome.tiles = sim::TileTimes{{{1, 2, 40, 20}}, {time(), time(), time(), time(), {}, time()}};
  }
  outcome.host_time_s = static_cast<double>(random() % 1000) / 1000;
  return outcome;
}

/// A ladder of levels with random outcomes, judged.
inline sim::LadderResult random_ladder(std::mt19937& random, sim::ErrorMeasure measure) {
  sim::Ladder ladder{
      "ladder" + std::to_string(random() % 100), "something, \"quoted\"", measure, {}, 0};
  std::vector<std::vector<sim::LevelOutcome>> outcomes;
  const bool is_simulated = measure == sim::ErrorMeasure::frame_time || random() % 2 == 0;
  for (std::size_t level = 0; level < 2 + random() % 5; ++level) {
    ladder.levels.push_back({"level " + std::to_string(level), {}, sim::LevelKind::simulation});
    outcomes.emplace_back(3, random_outcome(random, is_simulated));
    for (sim::LevelOutcome& repeat : outcomes.back()) {
      repeat.host_time_s = static_cast<double>(random() % 1000) / 1000;
    }
  }
  ladder.reference = random() % ladder.levels.size();
  return sim::result_of(ladder, outcomes);
}

}  // namespace maquette::tests
