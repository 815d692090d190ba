#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Json = nlohmann::json;

namespace {

/// A frame of a few pixels: a level takes milliseconds.
const std::string k_tiny_frame =
    " --set frame_memory.width=48pixels --set frame_memory.height=36pixels ";

std::string command_of(const ScratchDirectory& scratch, const std::string& options) {
  return "accuracy " + scratch.file("small.yaml", k_small_scene) + k_tiny_frame + options;
}

Outcome accuracy(const ScratchDirectory& scratch, const std::string& options,
                 const std::string& directory) {
  return run_maquette(
      command_of(scratch, "--outdir " + (scratch / directory).string() + " " + options));
}

Json errors_of(const ScratchDirectory& scratch, const std::string& directory) {
  return Json::parse(content_of(scratch / directory / "accuracy.json"));
}

Json ladder_of(const Json& errors, const std::string& name) {
  for (const Json& ladder : errors["ladders"]) {
    if (ladder["name"] == name) {
      return ladder;
    }
  }
  FAIL("no ladder " << name);
  return {};
}

Json level_of(const Json& ladder, const std::string& name) {
  for (const Json& level : ladder["levels"]) {
    if (level["level"] == name) {
      return level;
    }
  }
  FAIL("no level " << name);
  return {};
}

}  // namespace

TEST_CASE("every level is held against its reference, and only host times differ from run to run") {
  const ScratchDirectory scratch;
  const Outcome outcome = accuracy(scratch, "--repeats 1", "one");
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  REQUIRE(accuracy(scratch, "--repeats 2 --quiet", "two").exit_code == 0);
  for (const char* name : {"accuracy.csv", "accuracy.json", "tile_error.png"}) {
    CHECK(content_of(scratch / "one" / name) == content_of(scratch / "two" / name));
  }
  for (const char* ladder : {"processor", "bus", "number", "depth", "weight"}) {
    CHECK(outcome.output.find(std::string(ladder) + ": ") != std::string::npos);
    for (const char* ending : {".svg", ".png", ".gp"}) {
      const auto file =
          scratch / "one" / "plots" / (std::string(ladder) + "-over-host-time" + ending);
      CHECK(std::filesystem::file_size(file) > 1000);
    }
  }
  for (const Json& ladder : errors_of(scratch, "one")["ladders"]) {
    const Json reference = level_of(ladder, ladder["reference"]);
    CHECK(reference["error"] == 0);
    CHECK(reference["pixels_off"] == 0);
    for (const Json& board : reference["boards"]) {
      CHECK(board["wait_error_s"] == 0);
    }
  }
}

TEST_CASE("levels of the bus: the same picture, exact below an access, no wait when ideal") {
  const ScratchDirectory scratch;
  REQUIRE(accuracy(scratch, "--ladder bus --repeats 1 --quiet --quantum 500ns --quantum \"1 ms\"",
                   "out")
              .exit_code == 0);
  const Json bus = ladder_of(errors_of(scratch, "out"), "bus");
  REQUIRE(bus["levels"].size() == 5);
  CHECK(bus["reference"] == "signal");
  for (const Json& level : bus["levels"]) {
    CHECK(level["picture_largest"] == 0);
    CHECK(level["picture_mean"] == 0);
  }
  for (const char* name : {"transaction", "decoupled 500ns"}) {
    const Json exact = level_of(bus, name);
    CHECK(exact["frame_time_error"] == 0);
    CHECK(exact["wait_error_s"] == 0);
  }
  const Json ideal = level_of(bus, "ideal");
  CHECK(ideal["wait_s"] == 0);
  CHECK(ideal["wait_error"] == -1);
  CHECK(ideal["frame_time_s"].get<double>() <=
        level_of(bus, "transaction")["frame_time_s"].get<double>());
}

TEST_CASE("counted pixels are held against instructions: the same picture in another time") {
  const ScratchDirectory scratch;
  REQUIRE(accuracy(scratch, "--ladder processor --repeats 1 --quiet", "whole").exit_code == 0);
  const Json whole = ladder_of(errors_of(scratch, "whole"), "processor");
  CHECK(whole["reference"] == "instruction");
  const Json counted = level_of(whole, "counted");
  CHECK(counted["picture_largest"] == 0);
  CHECK(counted["frame_time_error"] != 0);
  CHECK(std::abs(counted["frame_time_error"].get<double>()) < 0.01);
  CHECK(counted["tile_error_median"] > 0);
  CHECK(counted["tile_error_median"].get<double>() < 0.02);
  CHECK(counted["tile_error_worst"] >= counted["tile_error_95"]);
  CHECK(level_of(whole, "instruction")["tile_error_worst"] == 0);
  CHECK(level_of(whole, "counted by tables")["picture_largest"] == 0);
  CHECK(level_of(whole, "recorded")["frame_time_s"] == counted["frame_time_s"]);
  CHECK(level_of(whole, "recorded")["wait_error_s"] == counted["wait_error_s"]);

  REQUIRE(
      accuracy(scratch, "--ladder processor --repeats 1 --quiet --sample 4", "part").exit_code ==
      0);
  const Json part = ladder_of(errors_of(scratch, "part"), "processor");
  CHECK(part["reference"] == "instruction 1/4");
  CHECK(level_of(part, "instruction 1/4")["wait_s"].is_null());
  CHECK(level_of(part, "counted")["wait_error"].is_null());
  CHECK(level_of(part, "counted")["picture_largest"] == 0);
  CHECK(level_of(part, "instruction 1/4")["frame_time_s"].get<double>() ==
        Approx(level_of(whole, "instruction")["frame_time_s"].get<double>()).epsilon(0.02));
}

TEST_CASE("a broken price of counted pixels shows as an error") {
  const ScratchDirectory scratch;
  REQUIRE(accuracy(scratch,
                   "--ladder processor --repeats 1 --quiet --set board.call_overhead.clocks=5200",
                   "out")
              .exit_code == 0);
  const Json ladder = ladder_of(errors_of(scratch, "out"), "processor");
  const Json tables = level_of(ladder, "counted by tables");
  CHECK(tables["frame_time_error"] > 1);
  CHECK(tables["tile_error_median"] > 1);
  CHECK(std::abs(level_of(ladder, "counted")["frame_time_error"].get<double>()) < 0.01);
}

TEST_CASE("a machine that executes no instructions has no such ladder, and it is told why") {
  const ScratchDirectory scratch;
  const Outcome outcome =
      accuracy(scratch, "--repeats 1 --quiet --set board.arithmetic=mc68881", "out");
  CHECK(outcome.exit_code == 0);
  CHECK(std::regex_search(outcome.errors, std::regex("processor is left out.*mc68881")));
  for (const Json& ladder : errors_of(scratch, "out")["ladders"]) {
    CHECK(ladder["name"] != "processor");
  }
  CHECK_FALSE(std::filesystem::exists(scratch / "out" / "tile_error.png"));
  CHECK(accuracy(scratch, "--ladder bus --repeats 1 --quiet --set board.arithmetic=mc68881", "bus")
            .errors.empty());
}

TEST_CASE("on a saturated bus no level but the exact one is right") {
  const ScratchDirectory scratch;
  REQUIRE(accuracy(scratch,
                   "--ladder bus --repeats 1 --quiet --quantum \"1 ms\" --set processors=128 "
                   "--machine m68020 --set frame_memory.video_priority=false "
                   "--set \"frame_memory.access_time=30 us\"",
                   "out")
              .exit_code == 0);
  const Json bus = ladder_of(errors_of(scratch, "out"), "bus");
  CHECK(level_of(bus, "decoupled 1 ms")["frame_time_error"].get<double>() > 0.05);
  CHECK(level_of(bus, "ideal")["frame_time_error"].get<double>() < -0.05);
}

TEST_CASE("the lines of the bus are the reference of boards of any clock") {
  const ScratchDirectory scratch;
  REQUIRE(accuracy(scratch,
                   "--ladder bus --repeats 1 --quiet --quantum 500ns --set board.clock=512MHz "
                   "--set processors=16",
                   "out")
              .exit_code == 0);
  const Json bus = ladder_of(errors_of(scratch, "out"), "bus");
  CHECK(bus["reference"] == "signal");
  CHECK(level_of(bus, "transaction")["frame_time_error"] == 0);
  CHECK(level_of(bus, "transaction")["wait_error_s"] == 0);
}

TEST_CASE("roots that are less near take less simulated time") {
  const ScratchDirectory scratch;
  const std::string scene =
      std::string(MAQUETTE_PROJECT_DIRECTORY) + "/scenes/primitives/revolution.yaml";
  REQUIRE(run_maquette("accuracy " + scene + k_tiny_frame + "--ladder roots --repeats 1 --quiet " +
                       "--outdir " + (scratch / "out").string())
              .exit_code == 0);
  const Json levels = ladder_of(errors_of(scratch, "out"), "roots")["levels"];
  REQUIRE(levels.size() > 2);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    CHECK(levels[i]["frame_time_s"].get<double>() <= levels[i - 1]["frame_time_s"].get<double>());
  }
  CHECK(levels.back()["frame_time_error"].get<double>() < -0.001);
}

TEST_CASE("a run at a level of the bus says so and runs again from its configuration") {
  const ScratchDirectory scratch;
  const std::string run = "run " + scratch.file("small.yaml", k_small_scene) + k_tiny_frame;
  const std::string first = (scratch / "first").string();
  REQUIRE(
      run_maquette(run + "--bus decoupled --quantum 20us --quiet --outdir " + first).exit_code ==
      0);
  CHECK(std::regex_search(content_of(scratch / "first" / "config.yaml"),
                          std::regex("level: decoupled\n *quantum: 20 us")));
  REQUIRE(run_maquette("run " + first + "/config.yaml --quiet --outdir " +
                       (scratch / "second").string())
              .exit_code == 0);
  CHECK(content_of(scratch / "first" / "stats.json") ==
        content_of(scratch / "second" / "stats.json"));
}

TEST_CASE("Bad input is refused before anything is written") {
  const ScratchDirectory scratch;
  struct Case {
    const char* options;
    const char* pattern;
  };
  const Case cases[] = {{"--quantum 5", "quantum.*us"},     {"--quantum=-1us", "quantum"},
                        {"--quantum \"2 s\"", "quantum"},   {"--ladder stair", "bus"},
                        {"--repeats 0", "repeats"},         {"--sample 0", "sample"},
                        {"--machine zx81", "zx81"},         {"--set processors=0", "processors"},
                        {"--set board.stack=256B", "stack"}};
  for (const Case& c : cases) {
    const Outcome outcome = accuracy(scratch, c.options, "out");
    INFO(c.options << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 2);
    CHECK(std::regex_search(outcome.errors, std::regex(c.pattern)));
    CHECK_FALSE(std::filesystem::exists(scratch / "out"));
  }
  CHECK(run_maquette("accuracy " + (scratch / "missing.yaml").string()).exit_code == 2);
  const std::string run = "run " + scratch.file("small.yaml", k_small_scene) + k_tiny_frame;
  const std::string out = " --outdir " + (scratch / "out").string();
  CHECK(run_maquette(run + "--bus decoupled --quantum 5" + out).exit_code == 2);
  CHECK(
      run_maquette(run + "--bus ideal --trace " + (scratch / "t.json").string() + out).exit_code ==
      2);
  CHECK_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST_CASE("An unwritable directory, and a machine that does not work, leave nothing") {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("occupied", "a file");
  CHECK(run_maquette(command_of(scratch, "--outdir " + file + "/out")).exit_code == 2);
  const Outcome outcome = accuracy(
      scratch,
      "--ladder bus --set 'frame_memory.width=600 pixels' --set 'frame_memory.height=400 pixels' "
      "--set 'bus.clock=1 kHz' --set 'bus.arbitration_clocks=100000 clocks'",
      "out");
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors.find("level bus, signal") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch / "out"));
}
