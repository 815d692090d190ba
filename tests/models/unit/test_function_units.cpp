#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <stdexcept>
#include <vector>

#include "models/bus/bus_levels.hpp"
#include "tests/models/unit/unit_run.hpp"

/// Machines whose boards hand out errands to units, against what queueing theory says of them.

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr PixelRectangle k_zone{8, 4, 48, 32};
constexpr Duration k_gap = 6 * k_clock;
constexpr Duration k_message_word = 10 * k_clock;  // a mailbox answers in 625 ns

MachineParameters with_units(int boards, UnitKind kind, int number) {
  MachineParameters parameters = machine(boards);
  kind_of(parameters, kind).number = number;
  return parameters;
}

/// So many long words without anybody else on the bus, arbitration apart.
Duration message(int longs) {
  const int words = 2 * longs;
  return words * k_message_word + (words - 1) * k_gap;
}

LegsOf always(const Legs& legs) {
  return [legs](PixelPosition) { return legs; };
}

double share(Duration part, Duration whole) {
  return static_cast<double>(part.count()) / static_cast<double>(whole.count());
}

}  // namespace

TEST_CASE("one board with one unit takes the sum of both, and of what they tell each other") {
  MachineParameters parameters = with_units(1, UnitKind::intersection, 1);
  parameters.bus.level = k_ideal_level;
  UnitRun run("machine", parameters, k_zone,
              always({leg(Stage::extents, 300), leg(Stage::intersection, 700, 9, 4),
                      leg(Stage::board, 100)}));
  sc_core::sc_start();
  check_unit_run(run.machine);
  const MachineStatistics statistics = run.machine.statistics();
  const Duration pixel =
      (300 + 700 + 100) * k_clock + k_tick + message(1 + 9) + message(1 + 4) + 2 * k_word + k_gap;
  CHECK(statistics.frame_time == 5000 * k_clock + k_zone.pixels() * pixel);
  CHECK(statistics.boards[0].wait_unit ==
        k_zone.pixels() * (700 * k_clock + k_tick + message(1 + 4)));
  REQUIRE(statistics.units.size() == 1);
  CHECK(statistics.units[0].units[0].errands == k_zone.pixels());
  CHECK(statistics.units[0].units[0].states.compute ==
        k_zone.pixels() * (700 * k_clock + 9 * k_gap));
}

TEST_CASE("a unit with costs and a clock of its own serves at them, and boards at theirs") {
  MachineParameters parameters = with_units(1, UnitKind::intersection, 1);
  FunctionUnitParameters& unit = kind_of(parameters, UnitKind::intersection);
  unit.costs = parameters.board.arithmetic;
  unit.costs->operations[static_cast<std::size_t>(maquette::firmware::Operation::node)].clocks =
      0.25;
  unit.clock_hz = 16e6;
  UnitRun run("machine", parameters, k_zone,
              always({leg(Stage::extents, 300), leg(Stage::intersection, 800, 9, 4)}));
  sc_core::sc_start();
  check_unit_run(run.machine);
  const MachineStatistics statistics = run.machine.statistics();
  CHECK(statistics.units[0].units[0].states.compute ==
        k_zone.pixels() * (100 * k_clock + 9 * k_gap));
  CHECK(statistics.boards[0].working == (5000 + k_zone.pixels() * 300) * k_clock);
}

TEST_CASE("boards with units keep the pixels that they own in their RAM") {
  MachineParameters parameters = with_units(1, UnitKind::intersection, 1);
  parameters.bus.level = k_ideal_level;
  parameters.allotment.order = Allotment::interlaced;
  parameters.board.ram_bytes = std::int64_t{1024} * 1024;
  const LegsOf legs =
      always({leg(Stage::extents, 300), leg(Stage::intersection, 700, 9, 4), leg(Stage::board, 9)});
  UnitRun central("central", parameters, k_zone, legs);
  parameters.frame_memory.place = FramePlace::boards;
  UnitRun own("own", parameters, k_zone, legs);
  parameters.boards = machine(4).boards;
  parameters.units.in_flight = 2;
  parameters.bus.level = k_transaction_level;
  UnitRun four("four", parameters, k_zone, legs);
  sc_core::sc_start();
  const std::int64_t pixels = k_zone.pixels();
  const Duration written = 2 * k_word + k_gap;
  const Duration kept = 2 * 5 * k_clock + k_gap;  // two cycles of the RAM, with a wait state each
  CHECK(own.machine.statistics().frame_time ==
        central.machine.statistics().frame_time + pixels * (kept - written));
  CHECK(own.machine.statistics().boards[0].words == pixels * 2 * (1 + 9));
  for (const UnitRun* run : {&central, &own, &four}) {
    check_unit_run(run->machine);
    const Picture picture = run->machine.frame_memory().picture();
    for (int column = k_zone.column0; column < k_zone.column0 + k_zone.width; ++column) {
      REQUIRE(picture.pixels[static_cast<std::size_t>(6 * picture.width + column)] ==
              colour({column, 6}));
    }
  }
}

TEST_CASE("without contention and arbitration a bus is ideal") {
  MachineParameters parameters = with_units(1, UnitKind::photometry, 1);
  parameters.bus.arbitration_clocks = 0;
  parameters.bus.handover_clocks = 0;
  const Legs legs{leg(Stage::extents, 300), leg(Stage::photometry, 444), leg(Stage::board, 5)};
  UnitRun arbitrated("arbitrated", parameters, k_zone, always(legs));
  parameters.bus.level = k_ideal_level;
  UnitRun ideal("ideal", parameters, k_zone, always(legs));
  sc_core::sc_start();
  check_unit_run(arbitrated.machine);
  check_unit_run(ideal.machine);
  CHECK(arbitrated.machine.statistics().frame_time == ideal.machine.statistics().frame_time);
}

TEST_CASE("a saturated unit does as many pixels as it can serve") {
  MachineParameters parameters = with_units(4, UnitKind::intersection, 1);
  parameters.units.in_flight = 3;
  UnitRun run("machine", parameters, k_zone,
              always({leg(Stage::extents, 500), leg(Stage::intersection, 20'000)}));
  sc_core::sc_start();
  check_unit_run(run.machine);
  const MachineStatistics statistics = run.machine.statistics();
  const BoardStatistics& unit = statistics.units[0].units[0].states;
  const Duration start = 5000 * k_clock;
  CHECK(share(unit.compute + unit.transfer + unit.wait_grant, statistics.frame_time - start) >
        0.999);
  CHECK(statistics.frame_time - start > k_zone.pixels() * 20'000 * k_clock);
  CHECK(statistics.units[0].units[0].longest_queue <= parameters.units.kinds[1].queue);
}

TEST_CASE("exponential work and service make the queue of machines and their repairman") {
  // M/M/1//N: N boards that compute for Z on the mean, one unit that serves in S.
  constexpr int k_boards = 4;
  constexpr double k_think_clocks = 600'000;
  constexpr double k_service_clocks = 250'000;
  constexpr int k_runs = 12;
  MachineParameters parameters = with_units(k_boards, UnitKind::intersection, 1);
  parameters.allotment.assignment = Assignment::on_demand;
  std::vector<std::unique_ptr<UnitRun>> runs;
  for (int i = 0; i < k_runs; ++i) {
    auto random = std::make_shared<std::mt19937>(1984 + i);
    const LegsOf legs = [random](PixelPosition) {
      std::exponential_distribution<double> one;
      const auto clocks = [&](double mean) {
        return static_cast<std::uint32_t>(mean * one(*random));
      };
      return Legs{leg(Stage::extents, clocks(k_think_clocks)),
                  leg(Stage::intersection, clocks(k_service_clocks), 0, 0)};
    };
    runs.push_back(
        std::make_unique<UnitRun>("machine" + std::to_string(i), parameters, k_zone, legs));
  }
  sc_core::sc_start();
  double weight = 1;
  double sum = 1;
  for (int broken = 1; broken <= k_boards; ++broken) {
    weight *= (k_boards - broken + 1) * k_service_clocks / k_think_clocks;
    sum += weight;
  }
  const double expected_s =
      static_cast<double>(k_zone.pixels()) * k_service_clocks / 8e6 / (1 - 1 / sum);
  std::vector<double> times_s;
  for (const auto& run : runs) {
    check_unit_run(run->machine);
    times_s.push_back(static_cast<double>(run->machine.statistics().frame_time.count()) * 1e-12);
  }
  const double mean = std::accumulate(times_s.begin(), times_s.end(), 0.0) / k_runs;
  double squares = 0;
  for (const double time_s : times_s) {
    squares += (time_s - mean) * (time_s - mean);
  }
  const double error = std::sqrt(squares / (k_runs - 1) / k_runs);
  constexpr double k_student_11 = 3.106;  // 99 %
  CHECK(std::abs(mean - expected_s) < k_student_11 * error);
  CHECK(error < 0.01 * expected_s);
}

TEST_CASE("a pipeline takes as long as its longest stage") {
  MachineParameters parameters = machine(1);
  parameters.units.in_flight = 6;
  parameters.bus.level = k_ideal_level;
  for (const UnitKind kind :
       {UnitKind::extents, UnitKind::intersection, UnitKind::combination, UnitKind::photometry}) {
    kind_of(parameters, kind).number = 1;
  }
  const auto legs = [](std::uint32_t intersection) {
    return always({leg(Stage::extents, 20'000), leg(Stage::intersection, intersection),
                   leg(Stage::combination, 20'000), leg(Stage::photometry, 20'000),
                   leg(Stage::board, 10)});
  };
  UnitRun balanced("balanced", parameters, k_zone, legs(20'000));
  UnitRun unbalanced("unbalanced", parameters, k_zone, legs(50'000));
  kind_of(parameters, UnitKind::intersection).number = 2;
  UnitRun doubled("doubled", parameters, k_zone, legs(40'000));
  sc_core::sc_start();
  const auto check = [](const UnitRun& run, std::uint32_t longest) {
    check_unit_run(run.machine);
    const Duration stage = longest * k_clock + message(1 + 3 + 7) + k_tick;
    const Duration time = run.machine.statistics().frame_time - 5000 * k_clock;
    // The pixels go through one after the other; the first and the last one alone.
    CHECK(time > k_zone.pixels() * longest * k_clock);
    CHECK(time < (k_zone.pixels() + 6) * (stage + k_tick));
  };
  check(balanced, 20'000);
  check(unbalanced, 50'000);
  check(doubled, 20'000);
  const MachineStatistics statistics = unbalanced.machine.statistics();
  for (const UnitKindStatistics& kind : statistics.units) {
    const bool is_longest = kind.kind == UnitKind::intersection;
    CHECK((share(kind.units[0].states.compute, statistics.frame_time) > 0.95) == is_longest);
  }
}

namespace {

/// A random machine, with as many pixels in flight as cannot deadlock, and legs of all stages in
/// any order, among them some of no time at all.
MachineParameters random_machine(std::mt19937& random) {
  const auto up_to = [&](int most) {
    return static_cast<int>(random() % static_cast<std::mt19937::result_type>(most + 1));
  };
  MachineParameters parameters = machine(1 + up_to(4));
  for (FunctionUnitParameters& kind : parameters.units.kinds) {
    kind.number = up_to(2);
    kind.queue = 1 + up_to(1);
    kind.choice = up_to(1) == 0 ? UnitChoice::first_come : UnitChoice::by_pixel;
    kind.request_level = up_to(3);
  }
  kind_of(parameters, UnitKind::extents).number = 1;
  const auto boards = static_cast<std::int64_t>(parameters.boards.size());
  std::int64_t most = most_pixels_in_flight(parameters.units) / boards;
  while (most < 1) {
    parameters.boards.pop_back();
    most = most_pixels_in_flight(parameters.units) /
           static_cast<std::int64_t>(parameters.boards.size());
  }
  parameters.units.in_flight = static_cast<int>(std::min<std::int64_t>(most, 5));
  parameters.board.release = up_to(1) == 0 ? ReleasePolicy::each_access : ReleasePolicy::block;
  parameters.allotment.assignment = up_to(3) == 0 ? Assignment::on_demand : Assignment::fixed;
  return parameters;
}

LegsOf random_legs(unsigned seed) {
  return [seed](PixelPosition position) {
    std::mt19937 random(seed + static_cast<unsigned>(position.column * 977 + position.row));
    Legs legs;
    for (auto i = random() % 12; i > 0; --i) {
      const auto ray = static_cast<maquette::firmware::RayKind>(random() % 6);
      legs.push_back(leg(static_cast<Stage>(random() % k_stage_count),
                         static_cast<std::uint32_t>(random() % 4 * 97),
                         static_cast<std::uint16_t>(random() % 9),
                         static_cast<std::uint16_t>(random() % 9), ray));
    }
    return legs;
  };
}

}  // namespace

TEST_CASE("no machine whose places its pixels in flight cannot fill stands still") {
  std::mt19937 random(5);
  std::vector<std::unique_ptr<UnitRun>> runs;
  for (unsigned i = 0; i < 60; ++i) {
    runs.push_back(std::make_unique<UnitRun>("machine" + std::to_string(i), random_machine(random),
                                             PixelRectangle{3, 5, 12, 9}, random_legs(i)));
  }
  sc_core::sc_start();
  for (const auto& run : runs) {
    check_unit_run(run->machine);
    const Picture picture = run->machine.frame_memory().picture();
    for (int column = 3; column < 15; ++column) {
      REQUIRE(picture.pixels[static_cast<std::size_t>(6 * picture.width + column)] ==
              colour({column, 6}));
    }
  }
}

TEST_CASE("levels of the bus agree on machines with units") {
  std::mt19937 random(77);
  std::vector<std::unique_ptr<UnitRun>> runs;
  for (unsigned i = 0; i < 8; ++i) {
    MachineParameters parameters = random_machine(random);
    for (const BusLevel& level : {k_transaction_level, k_signal_level, k_decoupled_level}) {
      parameters.bus.level = level;
      parameters.bus.quantum = Duration::zero();
      runs.push_back(std::make_unique<UnitRun>("machine" + std::to_string(runs.size()), parameters,
                                               PixelRectangle{3, 5, 6, 5}, random_legs(i)));
    }
  }
  sc_core::sc_start();
  const auto check = [](const BoardStatistics& a, const BoardStatistics& b) {
    CHECK(a.compute == b.compute);
    CHECK(a.wait_grant == b.wait_grant);
    CHECK(a.transfer == b.transfer);
    CHECK(a.wait_unit == b.wait_unit);
    CHECK(a.idle == b.idle);
    CHECK(a.words == b.words);
  };
  for (std::size_t i = 0; i < runs.size(); ++i) {
    INFO("run " << i);
    check_unit_run(runs[i]->machine);
    const MachineStatistics one = runs[i - i % 3]->machine.statistics();
    const MachineStatistics other = runs[i]->machine.statistics();
    CHECK(one.frame_time == other.frame_time);
    for (std::size_t board = 0; board < one.boards.size(); ++board) {
      check(one.boards[board], other.boards[board]);
    }
    for (std::size_t kind = 0; kind < one.units.size(); ++kind) {
      CHECK(one.units[kind].waited.sum == other.units[kind].waited.sum);
      for (std::size_t unit = 0; unit < one.units[kind].units.size(); ++unit) {
        check(one.units[kind].units[unit].states, other.units[kind].units[unit].states);
        CHECK(one.units[kind].units[unit].queued.sum == other.units[kind].units[unit].queued.sum);
      }
    }
  }
}

TEST_CASE("more pixels in flight than cannot deadlock are refused") {
  MachineParameters parameters = machine(2);
  kind_of(parameters, UnitKind::extents).number = 1;
  kind_of(parameters, UnitKind::extents).queue = 2;
  parameters.units.in_flight = 1000;
  UnitRun one_kind("one_kind", parameters, k_zone, always({leg(Stage::extents, 10)}));
  kind_of(parameters, UnitKind::photometry).number = 2;
  kind_of(parameters, UnitKind::photometry).queue = 1;
  CHECK(most_pixels_in_flight(parameters.units) == 3 + 4 - 1);
  parameters.units.in_flight = 3;
  UnitRun allowed("allowed", parameters, k_zone, always({leg(Stage::extents, 10)}));
  parameters.units.in_flight = 4;
  CHECK_THROWS_AS(UnitRun("refused", parameters, k_zone, always({leg(Stage::extents, 10)})),
                  std::invalid_argument);
}
