#include "sim/accuracy/outcome_bytes.hpp"
#include "tests/catch.hpp"
#include "tests/sim/accuracy/random_ladders.hpp"

using namespace maquette::sim;

TEST_CASE("an outcome comes back as it was, and a damaged one not at all") {
  std::mt19937 random(21);
  for (int round = 0; round < 50; ++round) {
    const LevelOutcome outcome = maquette::tests::random_outcome(random, round % 2 == 0);
    const std::string bytes = encode_outcome(outcome);
    const LevelOutcome back = decode_outcome(bytes);
    REQUIRE(back.simulated.has_value() == outcome.simulated.has_value());
    if (back.simulated) {
      CHECK(back.simulated->frame == outcome.simulated->frame);
      CHECK(back.simulated->waits == outcome.simulated->waits);
      CHECK(back.simulated->processor_clocks == outcome.simulated->processor_clocks);
      REQUIRE(back.tiles.has_value());
      CHECK(back.tiles->times == outcome.tiles->times);
      CHECK(back.tiles->grid.columns() == outcome.tiles->grid.columns());
      CHECK(back.tiles->grid.zone.column0 == outcome.tiles->grid.zone.column0);
      CHECK(back.tiles->grid.zone.row0 == outcome.tiles->grid.zone.row0);
      CHECK(back.tiles->grid.rows() == outcome.tiles->grid.rows());
    }
    CHECK(back.picture.width == outcome.picture.width);
    CHECK(back.picture.height == outcome.picture.height);
    CHECK(back.picture.pixels == outcome.picture.pixels);
    CHECK(back.host_time_s == outcome.host_time_s);
    CHECK_THROWS_AS(decode_outcome(bytes.substr(0, random() % bytes.size())), std::runtime_error);
  }
}
