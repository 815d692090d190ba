#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Json = nlohmann::json;

namespace {

const std::filesystem::path k_scenes = std::filesystem::path(MAQUETTE_PROJECT_DIRECTORY) / "scenes";

const std::string k_frame =
    " --set 'frame_memory.width=96 pixels' --set 'frame_memory.height=72 pixels'"
    " --set 'board.ram=1024 KiB' --quiet ";

/// The level `counted` of the ladder of processors.
Json counted_level(const std::filesystem::path& scene, const std::string& arithmetic) {
  const ScratchDirectory scratch;
  const Outcome outcome = run_maquette(
      "accuracy " + scene.string() + k_frame + " --ladder processor --repeats 1 --set " +
      "board.arithmetic=" + arithmetic + " --outdir " + (scratch / "out").string());
  INFO(scene << ": " << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const Json accuracy = Json::parse(content_of(scratch / "out" / "accuracy.json"));
  for (const Json& level : accuracy["ladders"][0]["levels"]) {
    if (level["level"] == "counted") {
      return level;
    }
  }
  FAIL("no level counted");
  return {};
}

void check_nearness(const std::filesystem::path& scene, const std::string& arithmetic) {
  const Json counted = counted_level(scene, arithmetic);
  INFO(scene << " " << arithmetic << ": " << counted.dump());
  CHECK(std::abs(counted["frame_time_error"].get<double>()) < 0.01);
  CHECK(counted["tile_error_median"].get<double>() < 0.02);
  CHECK(counted["tile_error_95"].get<double>() < 0.05);
  CHECK(counted["picture_largest"] == 0);
}

/// Statistics of a small frame of photo4.
Json statistics(const ScratchDirectory& scratch, const std::string& options) {
  const std::string directory = (scratch / "run").string();
  REQUIRE(run_maquette("run " + (k_scenes / "photo4.yaml").string() + k_frame + options +
                       " --outdir " + directory)
              .exit_code == 0);
  return Json::parse(content_of(directory + "/stats.json"));
}

}  // namespace

TEST_CASE("counted work comes near to the executed program for every scene") {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(k_scenes)) {
    if (entry.path().extension() == ".yaml" && entry.path().parent_path().filename() != "studies") {
      check_nearness(entry.path(), "motorola_ffp");
    }
  }
}

TEST_CASE("counted work comes near to the executed program whose arithmetic is executed too") {
  for (const char* scene : {"photo1.yaml", "photo3.yaml", "photo4.yaml", "primitives/cone.yaml",
                            "primitives/revolution.yaml", "primitives/torus.yaml"}) {
    check_nearness(k_scenes / scene, "maquette_ffp");
  }
}

TEST_CASE("counted work comes near to the executed program with IEEE numbers") {
  for (const char* scene : {"photo1.yaml", "photo3.yaml", "photo4.yaml", "primitives/cone.yaml",
                            "primitives/revolution.yaml", "primitives/torus.yaml"}) {
    check_nearness(k_scenes / scene, "ieee_single");
  }
}

TEST_CASE("statistics tell what counted work costs and where that is from") {
  const ScratchDirectory scratch;
  const Json calibrated = statistics(scratch, "")["costs"];
  CHECK(calibrated["from"] == "calibration");
  CHECK(calibrated["pixels"] > 700);
  CHECK(std::abs(calibrated["sum_error"].get<double>()) < 0.005);
  CHECK(calibrated["typical_error"] > 0);
  CHECK(calibrated["typical_error"].get<double>() < 0.05);
  CHECK(calibrated["clocks"]["multiply"].get<double>() > 423);
  const Json tables = statistics(scratch, "--set board.costs=tables")["costs"];
  CHECK(tables["from"] == "tables");
  CHECK(tables["pixels"] == 0);
  CHECK(tables["clocks"]["node"] != calibrated["clocks"]["node"]);
  CHECK(statistics(scratch, "--processor instruction")["costs"]["from"] == "execution");
}

TEST_CASE("boards that can not execute the program are counted by their tables") {
  const ScratchDirectory scratch;
  CHECK(statistics(scratch, "--machine mc68881")["costs"]["from"] == "tables");
  CHECK(statistics(scratch, "--machine m68020")["costs"]["from"] == "tables");
}

TEST_CASE("costs do not depend on clocks, waits, boards, allotment or where the database is") {
  const ScratchDirectory scratch;
  const auto multiply = [&](const std::string& options) {
    return statistics(scratch,
                      "--set board.ram_read_wait=0clocks --set "
                      "board.ram_write_wait=0clocks " +
                          options)["costs"]["clocks"];
  };
  const Json clocks = multiply("");
  for (const char* options :
       {"--set 'board.clock=12.5 MHz'", "--set processors=64", "--set allotment.order=tiles",
        "--set board.database=shared", "--set 'bus.data_width=32 bits'",
        "--set board.pixel_write=line", "--set allotment.assignment=on_demand"}) {
    INFO(options);
    CHECK(multiply(options) == clocks);
  }
}
