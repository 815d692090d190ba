#include <nlohmann/json.hpp>
#include <string>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A ball with a lamp, looked at by default from outside.
std::string scene_of(const std::string& target, const std::string& lamp,
                     const std::string& transparent = "false") {
  return "name: doubtful\n"
         "view: {eye: [0, 0, 10], target: " +
         target +
         ", up: [0, 1, 0], field_of_view: 20 deg}\n"
         "lights:\n"
         "  lamp: " +
         lamp +
         "\n"
         "background: [0, 0.2, 0.4]\n"
         "surfaces:\n"
         "  stone: {diffuse: [0.5, 0.5, 0.5], transparent: " +
         transparent +
         "}\n"
         "object: {sphere: {radius: 1}, surface: stone}\n";
}

constexpr const char* k_ahead = "[0, 0, 0]";
constexpr const char* k_lamp = "{position: [5, 5, 9]}";
constexpr const char* k_enclosed = "{position: [0, 0.5, 0]}";

struct Answer {
  Outcome outcome;
  std::string manifest;
};

Answer run_scene(const std::string& text, const std::string& options = "") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("doubtful.yaml", text);
  Answer answer;
  answer.outcome = run_maquette("run " + scene + k_small_frame + "--quiet --outdir " +
                                (scratch / "run").string() + " " + options);
  INFO(answer.outcome.errors);
  REQUIRE(answer.outcome.exit_code == 0);
  answer.manifest = content_of(scratch / "run" / "manifest.json");
  return answer;
}

}  // namespace

TEST_CASE("a scene that nothing speaks against is answered with no warning") {
  for (const std::string& text : {scene_of(k_ahead, k_lamp), std::string(k_small_scene)}) {
    const Answer answer = run_scene(text);
    CHECK(answer.outcome.errors.empty());
    CHECK(nlohmann::json::parse(answer.manifest).count("warnings") == 0);
  }
}

TEST_CASE("a light inside an opaque body is told of, with its place in the file") {
  const Answer answer = run_scene(scene_of(k_ahead, k_enclosed));
  CHECK_THAT(answer.outcome.errors,
             ContainsSubstring("doubtful.yaml:4:9: warning: the light lamp is inside an opaque "
                               "body"));
  const auto warnings = nlohmann::json::parse(answer.manifest).at("warnings");
  CHECK_THAT(warnings.at(0).get<std::string>(), ContainsSubstring("inside an opaque body"));
}

TEST_CASE("a light inside glass, or where there are no shadows, is meant") {
  CHECK(run_scene(scene_of(k_ahead, k_enclosed, "true")).outcome.errors.find("inside") ==
        std::string::npos);
  CHECK(run_scene(scene_of(k_ahead, k_enclosed), "--set shadows=false")
            .outcome.errors.find("inside") == std::string::npos);
}

TEST_CASE("a view that meets no body is told of, whether its useful zone is empty or not") {
  CHECK_THAT(run_scene(scene_of("[20, 0, 0]", k_lamp)).outcome.errors,
             ContainsSubstring("doubtful.yaml:2:7: warning: no body is within the view"));
  const std::string nothing =
      "\n  intersection:\n    - sphere: {radius: 1}\n      surface: stone\n"
      "    - sphere: {radius: 0.5}\n      place: {translate: [1.6, 0, 0]}\n      surface: stone\n"
      "    - sphere: {radius: 0.5}\n      place: {translate: [-1.6, 0, 0]}\n      surface: stone\n";
  std::string text = scene_of(k_ahead, k_lamp);
  text.replace(text.find(" {sphere"), std::string::npos, nothing);
  CHECK_THAT(run_scene(text).outcome.errors, ContainsSubstring("every pixel shows the background"));
}

TEST_CASE("a picture that nothing lights is told of") {
  CHECK_THAT(
      run_scene(scene_of(k_ahead, "{position: [5, 5, 9], intensity: [0, 0, 0]}")).outcome.errors,
      ContainsSubstring("doubtful.yaml:4:3: warning: nothing is lit"));
  CHECK_THAT(run_scene(scene_of(k_ahead, "{position: [0, 0, -9]}")).outcome.errors,
             ContainsSubstring("pixels that meet a body are black"));
}

TEST_CASE("a frame that takes days is told of before it is simulated") {
  const std::string slow =
      "--set board.clock='1 kHz' --set board.refresh_period='0 s' --set processors=1 "
      "--set frame_memory.width='240 pixels' --set frame_memory.height='180 pixels'";
  CHECK_THAT(run_scene(scene_of(k_ahead, k_lamp), slow).outcome.errors,
             ContainsSubstring("doubtful.yaml:1:1: warning: a board will compute for about"));
}
