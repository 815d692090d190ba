#include <cmath>
#include <numeric>

#include "sim/report/statistics_json.hpp"
#include "tests/catch.hpp"
#include "tests/program/program.hpp"

namespace {

using Catch::Matchers::ContainsSubstring;
using maquette::models::Duration;
using maquette::sim::FunctionStatistics;
using maquette::sim::NamedWork;
using maquette::sim::OperationCounts;
using maquette::sim::Statistics;
using maquette::tests::content_of;
using maquette::tests::k_small_scene;
using maquette::tests::Outcome;
using maquette::tests::run_maquette;
using maquette::tests::ScratchDirectory;

Outcome run_small(const ScratchDirectory& scratch, const std::string& name,
                  const std::string& options) {
  return run_maquette(
      "run " + scratch.file("small.yaml", k_small_scene) + " --outdir " +
      (scratch / name).string() +
      " --set frame_memory.width='96 pixels' --set frame_memory.height='72 pixels' " + options);
}

Statistics statistics_of(const ScratchDirectory& scratch, const std::string& name) {
  return maquette::sim::parse_statistics(content_of(scratch / name / "stats.json"), name);
}

OperationCounts sum_of(const std::vector<NamedWork>& works) {
  OperationCounts sum{};
  for (const NamedWork& work : works) {
    for (std::size_t i = 0; i < sum.size(); ++i) {
      sum[i] += work.work[i];
    }
  }
  return sum;
}

/// What all boards did.
OperationCounts whole_work(const Statistics& statistics) {
  OperationCounts sum = statistics.work;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    sum[i] += statistics.boards.size() * statistics.preprocess_work[i];
  }
  return sum;
}

void check_sums(const Statistics& statistics) {
  const FunctionStatistics& functions = statistics.functions;
  REQUIRE(functions.time > Duration::zero());
  const auto& times = functions.by_function.values;
  CHECK(std::accumulate(times.begin(), times.end(), Duration::zero()) == functions.time);
  const auto& rays = functions.by_ray;
  CHECK(rays.preprocessing + rays.primary + rays.reflected + rays.refracted + rays.shadow ==
        functions.time);
  CHECK(std::accumulate(functions.shadow_by_light.begin(), functions.shadow_by_light.end(),
                        Duration::zero()) == rays.shadow);
  CHECK(sum_of(functions.work_by_function) == whole_work(statistics));
  CHECK(sum_of(functions.work_by_ray) == whole_work(statistics));
}

}  // namespace

TEST_CASE("What functions and rays took sums to what boards worked, whatever the machine") {
  const ScratchDirectory scratch;
  for (const char* machine :
       {"", "--set processors=7 --threads 2", "--set board.costs=tables --set processors=3",
        "--set board.database=shared", "--machine m68020"}) {
    INFO(machine);
    const Outcome outcome = run_small(scratch, "run", machine);
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    const Statistics statistics = statistics_of(scratch, "run");
    check_sums(statistics);
    CHECK(statistics.functions.by_ray.reflected > Duration::zero());
    CHECK(statistics.functions.by_ray.refracted > Duration::zero());
    CHECK(statistics.functions.shadow_by_light.size() == 1);
    Duration computed{};
    for (const auto& board : statistics.boards) {
      computed += board.compute;
    }
    const auto boards = static_cast<std::int64_t>(statistics.boards.size());
    CHECK(statistics.functions.time <= computed / boards + Duration(1));
    CHECK_THAT(outcome.output, ContainsSubstring("intersection_sphere"));
  }
}

TEST_CASE("Extents change the work and nothing else, and tell what they spare") {
  const ScratchDirectory scratch;
  REQUIRE(run_small(scratch, "all", "").exit_code == 0);
  const Statistics all = statistics_of(scratch, "all");
  constexpr auto k_leaf = static_cast<std::size_t>(maquette::firmware::Operation::leaf);
  CHECK(all.extents.boxes.tests == 0);
  for (const auto* kind : {&all.extents.rectangles, &all.extents.spheres}) {
    CHECK(kind->tests > kind->hits);
    CHECK(kind->spared_leaves >= kind->tests - kind->hits);
  }
  for (const char* choice : {"none", "rectangles", "boxes", "spheres"}) {
    INFO(choice);
    REQUIRE(run_small(scratch, choice, std::string("--set extents=") + choice).exit_code == 0);
    CHECK(content_of(scratch / choice / "frame.png") == content_of(scratch / "all" / "frame.png"));
    const Statistics some = statistics_of(scratch, choice);
    check_sums(some);
    CHECK(some.rays.total == all.rays.total);
    CHECK(some.costs.clocks == all.costs.clocks);
    CHECK(some.work[k_leaf] > all.work[k_leaf]);
    CHECK((some.extents.rectangles.tests > 0) == (std::string(choice) == "rectangles"));
    CHECK((some.extents.spheres.tests > 0) == (std::string(choice) == "spheres"));
  }
  REQUIRE(run_small(scratch, "said", "--set extents=all").exit_code == 0);
  CHECK(content_of(scratch / "said" / "stats.json") == content_of(scratch / "all" / "stats.json"));
}

TEST_CASE("The steps of intersections' roots sum to the work, and a replay tells the same") {
  const ScratchDirectory scratch;
  const std::string record = (scratch / "torus.exr").string();
  const std::string run = "run " MAQUETTE_PROJECT_DIRECTORY
                          "/scenes/primitives/torus.yaml --set frame_memory.width='96 pixels' "
                          "--set frame_memory.height='72 pixels' --record " +
                          record + " --outdir ";
  REQUIRE(run_maquette(run + (scratch / "seen").string()).exit_code == 0);
  REQUIRE(run_maquette(run + (scratch / "again").string() + " --processor recorded").exit_code ==
          0);
  const Statistics statistics = statistics_of(scratch, "seen");
  REQUIRE(statistics.roots.intersections);
  const auto& roots = *statistics.roots.intersections;
  std::uint64_t found = 0;
  std::uint64_t steps = 0;
  for (const auto& some : roots.by_steps) {
    found += some.roots;
    steps += some.roots * static_cast<std::uint64_t>(some.steps);
  }
  OperationCounts intersections{};
  for (const NamedWork& function : statistics.functions.work_by_function) {
    if (function.name.rfind("intersection_", 0) == 0) {
      intersections = sum_of({{"", intersections}, function});
    }
  }
  using maquette::firmware::Operation;
  CHECK(found == intersections[static_cast<std::size_t>(Operation::root)]);
  CHECK(steps == intersections[static_cast<std::size_t>(Operation::root_step)]);
  CHECK(found == roots.found);
  CHECK(steps == roots.steps);
  CHECK(roots.found <= statistics.roots.found);
  CHECK(std::abs(roots.up_to_two + roots.three_to_five + roots.more - 1) < 1e-12);
  CHECK(content_of(scratch / "again" / "stats.json") ==
        content_of(scratch / "seen" / "stats.json"));
  REQUIRE(run_small(scratch, "none", "").exit_code == 0);
  CHECK_FALSE(statistics_of(scratch, "none").roots.intersections);
}

TEST_CASE("A record is one of its extents") {
  const ScratchDirectory scratch;
  const std::string record = (scratch / "none.exr").string();
  REQUIRE(run_small(scratch, "none", "--set extents=none --record " + record).exit_code == 0);
  const Outcome refused = run_small(scratch, "all", "--processor recorded --record " + record);
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, ContainsSubstring("a record of another scene"));
}

TEST_CASE("Boards that execute their program have all extents, and no functions told") {
  const ScratchDirectory scratch;
  REQUIRE(run_small(scratch, "run", "--processor instruction").exit_code == 0);
  const Statistics statistics = statistics_of(scratch, "run");
  CHECK_THAT(statistics.functions.from, ContainsSubstring("absent"));
  CHECK(statistics.functions.time == Duration::zero());
  const Outcome refused = run_small(scratch, "none", "--processor instruction --set extents=none");
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.errors, ContainsSubstring("extents"));
}
