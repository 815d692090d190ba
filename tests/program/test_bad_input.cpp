#include <regex>
#include <vector>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;

namespace {

/// Expects exit code 2, one message that matches, and no run directory.
void check_refused(const std::string& arguments, const ScratchDirectory& scratch,
                   const std::string& pattern) {
  const std::string directory = (scratch / "out").string();
  const Outcome outcome = run_maquette(arguments + " --outdir " + directory);
  INFO(arguments << "\n" << outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.output.empty());
  CHECK(std::regex_search(outcome.errors, std::regex(pattern)));
  CHECK_FALSE(std::filesystem::exists(directory));
}

std::string small_scene_with(const std::string& from, const std::string& to) {
  std::string text = k_small_scene;
  const std::size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST_CASE("Bad scenes are refused with file, line and column") {
  struct Case {
    const char* from;
    const char* to;
    const char* pattern;
  };
  const std::vector<Case> cases = {
      {"ambient:", "ambiance:", R"(scene\.yaml:5:1: .*ambi)"},
      {"field_of_view: 30 deg", "field_of_view: 30 m", R"(scene\.yaml:2:\d+: .*deg)"},
      {"surface: red", "surface: green", R"(scene\.yaml:\d+:\d+: .*green)"},
      {"radius: 0.6", "radius: -1", R"(scene\.yaml:\d+:\d+: )"},
      {"radius: 0.6", "radius: nan", R"(scene\.yaml:\d+:\d+: )"},
      {"background: [0, 0.1, 0.3]", "background: [0, 0.1]", R"(scene\.yaml:6:\d+: )"},
      {"object:", "object", R"(scene\.yaml:\d+:\d+: )"},
      {"union:", "onion:", R"(scene\.yaml:\d+:\d+: .*onion)"},
      {"target: [0, 0, 0.4]", "target: [0, -6, 3]", R"(scene\.yaml:2:\d+: )"},
      {"diffuse: [0.8, 0.1, 0.1]", "diffuse: [1.8, 0.1, 0.1]", R"(scene\.yaml:\d+:\d+: )"},
      {"{translate: [0.5, -0.5, 0.5]}", "{scale: 0}", R"(scene\.yaml:\d+:\d+: )"},
  };
  for (const Case& c : cases) {
    const ScratchDirectory scratch;
    const std::string scene = scratch.file("scene.yaml", small_scene_with(c.from, c.to));
    check_refused("run " + scene, scratch, c.pattern);
  }
}

TEST_CASE("Bad options are refused") {
  const ScratchDirectory scratch;
  const std::string run = "run " + scratch.file("scene.yaml", k_small_scene);
  check_refused(run + " --set processors=0", scratch, R"(processors=0:1:\d+: )");
  check_refused(run + " --set procesors=2", scratch, "procesors");
  check_refused(run + " --set processors", scratch, "processors");
  check_refused(run + " --set lights.kye.position=[1,2,3]", scratch, "kye.*allowed: key");
  check_refused(run + " --set surfaces.green.specular=1", scratch, "green.*allowed: red");
  check_refused(run + " --set board.clock=8", scratch, "MHz");
  check_refused(run + " --machine no-such-machine", scratch, "no-such-machine");
  check_refused(run + " --threads 0", scratch, "threads");
  check_refused(run + " --processor abacus", scratch, "counted");
  check_refused(run + " --bus string", scratch, "transaction");
  check_refused(run + " --snapshot 5", scratch, R"(--snapshot 5:1:1: .*s)");
  check_refused(run + " --snapshot-shown=-1s", scratch, "before the frame");
  check_refused(run + " --frobnicate", scratch, "frobnicate");
  check_refused("run " + (scratch / "missing.yaml").string(), scratch, "missing.yaml");
  check_refused("run " + scratch.path().string(), scratch, ".");
}

TEST_CASE("A scene that a board cannot hold is refused with the figure, unless allowed") {
  const ScratchDirectory scratch;
  const std::string run = "run " + scratch.file("scene.yaml", k_small_scene) + k_small_frame;
  check_refused(run + "--set board.ram=32KiB", scratch, R"(scene\.yaml:\d+:\d+: .*\d+ more than)");
  check_refused(run + "--set board.crossings=4", scratch, R"(needs \d+ crossings.* has 4)");
  check_refused(run + "--set board.waiting_rays=1", scratch, R"(needs \d+ waiting rays.* has 1)");
  check_refused(run + "--set board.stack=256B", scratch, R"(needs \d+ bytes of stack.* has 256)");
  const Outcome allowed =
      run_maquette(run + "--set board.ram=32KiB --set board.allow_overflow=true" +
                   " --quiet --outdir " + (scratch / "out").string());
  INFO(allowed.errors);
  CHECK(allowed.exit_code == 0);
}

TEST_CASE("A machine whose bus times out is reported, not simulated on") {
  const ScratchDirectory scratch;
  const std::string run = "run " + scratch.file("scene.yaml", k_small_scene) + k_small_frame;
  const Outcome outcome = run_maquette(
      run + "--set bus.timeout=8us --set frame_memory.access_time=20us" +
      " --set frame_memory.video_priority=false --quiet --outdir " + (scratch / "out").string());
  INFO(outcome.errors);
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors.find("bus") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch / "out" / "stats.json"));
}

TEST_CASE("A frame that takes longer than simulated time goes is refused with how long") {
  const ScratchDirectory scratch;
  const std::string scene =
      "run " + std::string(MAQUETTE_PROJECT_DIRECTORY) + "/scenes/photo4.yaml";
  const auto refused = [&](const std::string& options) {
    const Outcome outcome =
        run_maquette(scene + " " + options + " --outdir " + (scratch / "out").string());
    CHECK(outcome.exit_code == 2);
    CHECK_FALSE(std::filesystem::exists(scratch / "out" / "stats.json"));
    return outcome.errors;
  };
  CHECK_THAT(refused("--set 'board.clock=1 kHz' --set 'board.refresh_period=0 s' "
                     "--set processors=1"),
             Catch::Matchers::ContainsSubstring("board0 would compute for at least 1"));
  CHECK_THAT(refused("--set 'board.clock=4 MHz' --set board.call_overhead.clocks=10000000 "
                     "--set board.costs=tables"),
             Catch::Matchers::ContainsSubstring("board0 would compute for at least 1"));
  CHECK_THAT(refused("--set 'bus.clock=1 kHz' --set 'bus.arbitration_clocks=100000 clocks'"),
             Catch::Matchers::ContainsSubstring(
                 "the bus would be busy with the pixels for at least 142.1 days"));
  CHECK_THAT(refused("--snapshot '9223372 s'"),
             Catch::Matchers::ContainsSubstring("up to 8640000 s"));
}

TEST_CASE("An output that cannot be written is an error before the simulation") {
  const ScratchDirectory scratch;
  const std::string file = scratch.file("occupied", "a file");
  const Outcome outcome = run_maquette("run " + scratch.file("scene.yaml", k_small_scene) +
                                       k_small_frame + "--quiet --outdir " + file + "/out");
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors.find("occupied") != std::string::npos);
}

TEST_CASE("Comparing needs two run directories") {
  const ScratchDirectory scratch;
  const Outcome outcome =
      run_maquette("compare " + scratch.path().string() + " " + scratch.path().string());
  CHECK(outcome.exit_code == 2);
  CHECK_FALSE(outcome.errors.empty());
}
