#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>

#include "sim/page/csv.hpp"
#include "sim/page/html.hpp"
#include "tests/catch.hpp"
#include "tests/program/page_reader.hpp"
#include "tests/program/program.hpp"
#include "tests/sim/page/well_formed.hpp"

using namespace maquette::tests;
using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;

TEST_CASE("A sweep's page has every cell of its table") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::string directory = (scratch / "sweep").string();
  const Outcome sweep = run_maquette("sweep " + scene + k_small_frame +
                                     "--vary processors=1,2 --quiet --outdir " + directory);
  INFO(sweep.errors);
  REQUIRE(sweep.exit_code == 0);
  const std::string page = report_of(directory);
  CHECK(ill_formed(page).empty());
  const auto lines = parse_csv(content_of(scratch / "sweep" / "table.csv"), "table.csv");
  REQUIRE(lines.size() == 3);
  for (const auto& line : lines) {
    for (const std::string& cell : line) {
      CHECK_THAT(page, ContainsSubstring(">" + text(cell).markup + "<"));
    }
  }
  std::ofstream(scratch / "sweep" / "table.csv") << "a,b\n1\n";
  const Outcome damaged = run_maquette("report " + directory);
  CHECK(damaged.exit_code == 2);
  CHECK_THAT(damaged.errors, ContainsSubstring("table.csv:2:1:"));
}

TEST_CASE("A point of a sweep runs again to its statistics, and the sweep's page shows the run") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const std::string directory = (scratch / "sweep").string();
  REQUIRE(run_maquette("sweep " + scene + k_small_frame +
                       "--vary processors=1,3 --vary bus.arbitration=priority,round_robin --quiet "
                       "--outdir " +
                       directory)
              .exit_code == 0);
  const std::string again = "run --sweep " + directory + "/study.yaml --quiet ";
  CHECK_THAT(report_of(directory), !ContainsSubstring("as a run of its own;"));
  for (const int point : {0, 1, 2, 3}) {
    const std::string name = "point-" + std::to_string(point);
    const Outcome run =
        run_maquette(fmt::format("{} --point {} --outdir {}/{}", again, point, directory, name));
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
    const auto kept = nlohmann::json::parse(
        content_of(scratch / "sweep" / "points" / ("00000" + std::to_string(point) + ".json")));
    const auto own = nlohmann::json::parse(content_of(scratch / "sweep" / name / "stats.json"));
    CHECK(kept["statistics"] == own);
  }
  const std::string page = report_of(directory);
  CHECK(ill_formed(page).empty());
  CHECK_THAT(page, ContainsSubstring("Point 3 as a run of its own; its statistics are those of"));
  CHECK_THAT(page, ContainsSubstring("arbitration: round_robin"));
  CHECK_THAT(page, !ContainsSubstring("DIFFER"));
  CHECK(run_maquette(again + "--point 3 --outdir " + directory + "/point-0").exit_code == 0);
  CHECK_THAT(report_of(directory), ContainsSubstring("ITS STATISTICS DIFFER"));
}

TEST_CASE("A point is run of a study alone, and of one that has it") {
  const ScratchDirectory scratch;
  const auto refused = [](const std::string& arguments, const std::string& reason) {
    INFO(arguments);
    const Outcome outcome = run_maquette("run " + arguments);
    CHECK(outcome.exit_code == 2);
    CHECK_THAT(outcome.errors, ContainsSubstring(reason));
  };
  const std::string study =
      scratch.file("study.yaml", "name: two\nscene: photo4\nvary: {processors: [1, 2]}\n");
  refused("--sweep " + study + " --point 2", "the study has the points 0 to 1");
  refused("--sweep " + study, "--point");
  refused("--point 1", "--sweep");
  refused("photo4 --sweep " + study + " --point 1", "SCENE");
  refused("--sweep " + study + " --point 1 --set processors=8", "--set");
  refused("", "SCENE is required");
  const std::string bare = scratch.file("bare.yaml", "name: two\nvary: {processors: [1, 2]}\n");
  refused("--sweep " + bare + " --point 1", "`scene` is missing");
}

TEST_CASE("The page of a stability has the nearest bounds first") {
  const ScratchDirectory scratch;
  const auto row = [](const char* group, const char* value, const char* bound, const char* holds) {
    return fmt::format(R"({{"scalar": "float", "group": "{}", "case": "c", "counted": "n", )"
                       R"("value": {}, "bound": {}, "holds": {}}})",
                       group, value, bound, holds);
  };
  (void)scratch.file("stability.json", "{\"rows\": [" + row("far", "1", "10", "true") + "," +
                                           row("told", "1", "null", "true") + "," +
                                           row("broken", "11", "10", "false") + "," +
                                           row("near", "9", "10", "true") + "]}");
  const std::string shown = read_by_people(report_of(scratch.path()));
  CHECK(std::regex_search(shown, std::regex("broken[^<]*BROKEN\\s+near[^<]*holds\\s+far")));
  (void)scratch.file("stability.json", "{\"rows\": [3]}");
  CHECK(run_maquette("report " + scratch.path().string()).exit_code == 2);
}

TEST_CASE("The page of a sequence has each frame with its times and what it has loaded anew") {
  const ScratchDirectory scratch;
  const std::string scene =
      scratch.file("moving.yaml",
                   "name: moving\n"
                   "view: {eye: [4, -6, 3], target: [0, 0, 0.5], field_of_view: 30 deg}\n"
                   "lights: {key: {position: [5, -5, 9]}}\n"
                   "surfaces: {red: {diffuse: [0.8, 0.2, 0.1]}}\n"
                   "object: {sphere: {radius: 0.5}, surface: red}\n"
                   "sequence: {frames: 3, vary: {object.sphere.radius: [0.5, 0.8, 0.8]}}\n");
  const std::string directory = (scratch / "moving").string();
  const Outcome run =
      run_maquette("run " + scene + k_small_frame + "--report --quiet --outdir " + directory);
  INFO(run.errors);
  REQUIRE(run.exit_code == 0);
  const std::string page = content_of(scratch / "moving" / "report.html");
  CHECK(report_of(directory) == page);
  CHECK(ill_formed(page).empty());
  const std::string shown = read_by_people(page);
  const auto sequence = nlohmann::json::parse(content_of(scratch / "moving" / "sequence.json"));
  double whole = 0;
  for (const auto& frame : sequence["frames"]) {
    whole += frame["load_s"].get<double>() + frame["time_s"].get<double>();
    CHECK_THAT(shown, ContainsSubstring(fmt::format("{:.4f}", frame["time_s"].get<double>())));
    CHECK_THAT(shown, ContainsSubstring(fmt::format("{:.6f}", frame["load_s"].get<double>())));
    CHECK_THAT(shown, ContainsSubstring(fmt::format("{:.4f}", whole)));
  }
  // The third frame is as the second, and is told to be.
  const std::regex change(R"(1\s+object\.sphere\.radius\s+0\.5\s+0\.8\s)");
  CHECK(std::regex_search(shown, change));
  CHECK_THAT(shown, !ContainsSubstring("2  object."));
  CHECK_THAT(shown, ContainsSubstring("0.00 %"));
  std::filesystem::remove(scratch / "moving" / "stats-0001.json");
  CHECK_THAT(read_by_people(report_of(directory)), ContainsSubstring("1 of 3 frames"));
  std::filesystem::remove(scratch / "moving" / "frame-0000.png");
  CHECK(run_maquette("report " + directory).exit_code == 2);
}
