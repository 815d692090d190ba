#include <algorithm>
#include <cmath>

#include "tests/catch.hpp"
#include "tests/sim/accuracy/random_ladders.hpp"

using namespace maquette::sim;
using maquette::models::Duration;
using maquette::tests::random_ladder;
using maquette::tests::random_outcome;

TEST_CASE("errors are differences from the reference, of every board and pixel") {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    const LevelOutcome reference = random_outcome(random, true);
    const LevelOutcome outcome = random_outcome(random, true);
    const LevelError error = error_of(outcome, reference);
    REQUIRE(error.simulated.has_value());
    CHECK(reference.simulated->frame + error.simulated->frame.absolute == outcome.simulated->frame);
    Duration worst{};
    for (std::size_t board = 0; board < 2; ++board) {
      const TimeError& wait = error.simulated->waits[board];
      CHECK(reference.simulated->waits[board] + wait.absolute == outcome.simulated->waits[board]);
      CHECK(static_cast<double>(reference.simulated->waits[board].count()) * (1 + *wait.relative) ==
            Approx(static_cast<double>(outcome.simulated->waits[board].count())));
      worst = std::max(worst, std::chrono::abs(wait.absolute));
    }
    CHECK(std::chrono::abs(error.simulated->worst_wait->absolute) == worst);

    int largest = 0;
    double sum = 0;
    int off = 0;
    for (std::size_t i = 0; i < 15; ++i) {  // greys
      const int change = std::abs(static_cast<int>(outcome.picture.pixels[i] & 0xffU) -
                                  static_cast<int>(reference.picture.pixels[i] & 0xffU));
      largest = std::max(largest, change);
      sum += change;
      off += change > 1 ? 1 : 0;
    }
    CHECK(error.picture.largest == largest);
    CHECK(error.picture.mean == Approx(sum / 15));
    CHECK(error.picture.pixels_off == off);
    CHECK(magnitude_of(error, ErrorMeasure::picture) == error.picture.mean);
    CHECK(magnitude_of(error, ErrorMeasure::frame_time) ==
          std::abs(*error.simulated->frame.relative));
  }
}

TEST_CASE("waits that a level does not know have no error") {
  std::mt19937 random(4);
  LevelOutcome reference = random_outcome(random, true);
  reference.simulated->waits.clear();
  const LevelError error = error_of(random_outcome(random, true), reference);
  REQUIRE(error.simulated.has_value());
  CHECK(error.simulated->waits.empty());
  CHECK_FALSE(error.simulated->worst_wait.has_value());
}

TEST_CASE("a wait of nothing has no relative error but that of nothing") {
  LevelOutcome reference;
  reference.picture = {1, 1, {0}};
  reference.simulated = {Duration{7}, {Duration{0}, Duration{0}}, 0};
  LevelOutcome outcome = reference;
  outcome.simulated->waits[1] = Duration{5};
  const LevelError error = error_of(outcome, reference);
  CHECK(error.simulated->waits[0].relative == 0.0);
  CHECK_FALSE(error.simulated->waits[1].relative.has_value());
  CHECK(error.simulated->worst_wait->absolute == Duration{5});
}

TEST_CASE("without a machine there are no times to be wrong") {
  std::mt19937 random(4);
  const LevelError error = error_of(random_outcome(random, false), random_outcome(random, true));
  CHECK_FALSE(error.simulated.has_value());
  CHECK(std::isinf(magnitude_of(error, ErrorMeasure::frame_time)));
}

TEST_CASE("the reference has no error, the cheapest and the best level are on the front") {
  std::mt19937 random(5);
  for (int round = 0; round < 200; ++round) {
    const auto measure = round % 2 == 0 ? ErrorMeasure::frame_time : ErrorMeasure::picture;
    const LadderResult result = random_ladder(random, measure);
    const LevelResult& reference = result.levels[result.ladder.reference];
    CHECK(reference.magnitude == 0);
    CHECK(reference.error.picture.pixels_off == 0);
    if (reference.error.simulated) {
      CHECK(reference.error.simulated->frame.absolute == Duration::zero());
      CHECK(reference.error.simulated->worst_wait->absolute == Duration::zero());
    }
    double least_cost = 1e9;
    bool cheapest_is_on = false;
    for (const LevelResult& level : result.levels) {
      CHECK(level.host.least_s <= level.host.median_s);
      CHECK(level.host.median_s <= level.host.most_s);
      if (level.host.median_s < least_cost) {
        least_cost = level.host.median_s;
        cheapest_is_on = false;
      }
      cheapest_is_on =
          cheapest_is_on || (level.host.median_s == least_cost && level.is_on_host_front);
      if (measure == ErrorMeasure::frame_time || !level.simulated) {
        CHECK_FALSE(level.is_on_simulated_front);
      }
    }
    CHECK(cheapest_is_on);
  }
}
