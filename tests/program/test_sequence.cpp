#include <filesystem>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

#include <nlohmann/json.hpp>

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

const std::string k_sequence =
    "view: {eye: [4, -6, 3], target: [0, 0, 0.5], field_of_view: 30 deg}\n"
    "lights: {key: {position: [5, -5, 9]}}\n"
    "surfaces: {red: {diffuse: [0.8, 0.2, 0.1]}, grey: {diffuse: 0.6}}\n"
    "object: {union: [{half_space: {}, surface: grey}, {sphere: {radius: 0.5}, surface: red}]}\n";

std::string scene_of(const std::string& extra) { return k_sequence + extra; }

const std::string k_coarse =
    " --set 'frame_memory.width=48 pixels' --set 'frame_memory.height=36 pixels'";

nlohmann::json json_of(const std::filesystem::path& file) {
  return nlohmann::json::parse(content_of(file));
}

const std::string k_frames =
    "sequence: {frames: 3, vary: {object.union.1.sphere.radius: [0.5, 0.8, 1.1]}}\n";

/// A frame of the sequence as a scene of its own.
std::string alone(const std::string& radius) {
  std::string text = k_sequence;
  const std::string before = "radius: 0.5";
  return text.replace(text.find(before), before.size(), "radius: " + radius);
}

TEST_CASE("frames of a sequence are those of their scenes, but for what need not be loaded") {
  const ScratchDirectory scratch;
  const std::string sequence = scratch.file("sequence.yaml", scene_of(k_frames));
  for (const std::string options :
       {"", " --set board.database=shared", " --processor instruction",
        " --processor instruction --set board.arithmetic=maquette_ffp",
        " --set units.photometry.number=2 --set units.extents.number=2"}) {
    CAPTURE(options);
    const Outcome outcome = run_maquette("run " + sequence + options + k_coarse + " --outdir " +
                                         (scratch / "all").string());
    INFO(outcome.errors);
    REQUIRE(outcome.exit_code == 0);
    double sum = 0;
    for (int frame = 0; frame < 3; ++frame) {
      const std::string number = "000" + std::to_string(frame);
      const std::string scene = scratch.file(
          "alone.yaml",
          alone(std::vector<std::string>{"0.5", "0.8", "1.1"}.at(static_cast<std::size_t>(frame))));
      REQUIRE(run_maquette("run " + scene + options + k_coarse + " --quiet --outdir " +
                           (scratch / "alone").string())
                  .exit_code == 0);
      CHECK(content_of(scratch / "all" / ("frame-" + number + ".png")) ==
            content_of(scratch / "alone" / "frame.png"));
      const auto in_sequence = json_of(scratch / "all" / ("stats-" + number + ".json"));
      const auto by_itself = json_of(scratch / "alone" / "stats.json");
      CHECK(in_sequence["work"] == by_itself["work"]);
      CHECK(in_sequence["frame"]["preprocess_s"] == by_itself["frame"]["preprocess_s"]);
      CHECK(in_sequence["frame"]["synthesis_s"].get<double>() ==
            Approx(by_itself["frame"]["synthesis_s"].get<double>()).epsilon(1e-4));
      const double load = in_sequence["frame"]["load_s"].get<double>();
      const double whole = by_itself["frame"]["load_s"].get<double>();
      if (frame == 0) {
        CHECK(load == whole);
      } else {
        CHECK(load > 0);
        CHECK(load < whole / 20);
      }
      sum += load + in_sequence["frame"]["time_s"].get<double>();
    }
    const auto together = json_of(scratch / "all" / "sequence.json");
    CHECK(together["time_s"].get<double>() == Approx(sum).epsilon(1e-12));
    CHECK(together["frames"].size() == 3);
    CHECK_FALSE(together["partial"].get<bool>());
    CHECK_THAT(outcome.output, ContainsSubstring("sequence time"));
  }
}

/// Runs a sequence of three frames: the last one loads little, and its picture is that of its scene
/// alone, not that of the first.
void check_reloading(const ScratchDirectory& scratch, const std::string& sequence,
                     const std::string& alone, const std::string& options) {
  const Outcome outcome = run_maquette("run " + sequence + options + k_coarse + " --outdir " +
                                       (scratch / "all").string());
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  const auto first = json_of(scratch / "all" / "stats-0000.json");
  const auto last = json_of(scratch / "all" / "stats-0002.json");
  CHECK(last["frame"]["load_s"].get<double>() > 0);
  CHECK(last["frame"]["load_s"].get<double>() < first["frame"]["load_s"].get<double>() / 200);
  REQUIRE(run_maquette("run " + alone + options + k_coarse + " --quiet --outdir " +
                       (scratch / "alone").string())
              .exit_code == 0);
  CHECK(content_of(scratch / "all" / "frame-0002.png") ==
        content_of(scratch / "alone" / "frame.png"));
  CHECK(content_of(scratch / "all" / "frame-0002.png") !=
        content_of(scratch / "all" / "frame-0000.png"));
}

TEST_CASE("where a point of a net moves the host loads it alone, and boards make the patches") {
  const ScratchDirectory scratch;
  const auto scene = [](const std::string& height, const std::string& more) {
    return "view: {eye: [4, -6, 3], target: [0, 0, 0.5], field_of_view: 30 deg}\n"
           "lights: {key: {position: [5, -5, 9]}}\n"
           "surfaces: {red: {diffuse: [0.8, 0.2, 0.1]}}\n"
           "object: {surface: red, patches: {basis: b_spline, grid: {columns: 4}, points: [[-3, "
           "-3, 0], [-1, -3, 0], [1, -3, 0], [3, -3, 0], [-3, -1, 0], [-1, -1, " +
           height +
           "], [1, -1, 1], [3, -1, 0], [-3, 1, 0], [-1, 1, 1], [1, 1, 1], [3, 1, 0], [-3, 3, 0], "
           "[-1, 3, 0], [1, 3, 0], [3, 3, 0]]}}\n" +
           more;
  };
  const std::string sequence = scratch.file(
      "sequence.yaml", scene("1",
                             "sequence: {frames: 3, vary: {object.patches.points.5.2: [1, 1.1, "
                             "1.3]}}\n"));
  for (const std::string options :
       {"", " --processor instruction", " --set units.intersection.number=64"}) {
    CAPTURE(options);
    check_reloading(scratch, sequence, scratch.file("alone.yaml", scene("1.3", "")), options);
  }
}

TEST_CASE("where control points move the host loads them alone, and boards convert them") {
  const ScratchDirectory scratch;
  const auto scene = [](const std::string& amount, const std::string& more) {
    return "view: {eye: [4, -6, 3], target: [0, 0, 0.8], field_of_view: 30 deg}\n"
           "lights: {key: {position: [5, -5, 9]}}\n"
           "surfaces: {red: {diffuse: [0.8, 0.2, 0.1]}}\n"
           "object: {surface: red, revolution: {points: [[0.5, 0], [0.6, 0.2], [0.7, 0.5], [0.6, "
           "0.9], [0.4, 1.2], [0.5, 1.5]], displacements: {swell: {amount: " +
           amount + ", by: [[0, 0], [0, 0], [0, 0], [1, 0], [1, 0], [0, 0]]}}}}\n" + more;
  };
  const std::string sequence = scratch.file(
      "sequence.yaml", scene("0",
                             "sequence: {frames: 3, vary: {object.revolution.displacements."
                             "swell.amount: [0, 0.02, 0.05]}}\n"));
  for (const std::string options : {"", " --set board.database=shared", " --processor instruction",
                                    " --processor instruction --set board.database=shared"}) {
    CAPTURE(options);
    check_reloading(scratch, sequence, scratch.file("alone.yaml", scene("0.05", "")), options);
  }
}

TEST_CASE("one frame of a sequence can be run alone, with all that is of one frame") {
  const ScratchDirectory scratch;
  const std::string sequence = scratch.file("sequence.yaml", scene_of(k_frames));
  REQUIRE(
      run_maquette("run " + sequence + k_coarse + " --quiet --outdir " + (scratch / "all").string())
          .exit_code == 0);
  REQUIRE(run_maquette("run " + sequence + k_coarse +
                       " --quiet --frame 2 --snapshot '1 s' --outdir " + (scratch / "one").string())
              .exit_code == 0);
  CHECK(content_of(scratch / "one" / "frame.png") ==
        content_of(scratch / "all" / "frame-0002.png"));
  CHECK(content_of(scratch / "one" / "stats.json") ==
        content_of(scratch / "all" / "stats-0002.json"));
  CHECK(std::filesystem::exists(scratch / "one" / "snapshot-1s.png"));
  const Outcome beyond =
      run_maquette("run " + sequence + " --frame 3 --outdir " + (scratch / "no").string());
  CHECK(beyond.exit_code == 2);
  CHECK_THAT(beyond.errors, ContainsSubstring("frames 0 to 2 are allowed"));
  const Outcome of_one =
      run_maquette("run " + sequence + " --snapshot '1 s' --outdir " + (scratch / "no").string());
  CHECK(of_one.exit_code == 2);
  CHECK_THAT(of_one.errors, ContainsSubstring("--frame N"));
  CHECK_FALSE(std::filesystem::exists(scratch / "no"));
}

TEST_CASE("a sequence of what is no part of a scene is refused before the first is simulated") {
  const ScratchDirectory scratch;
  const std::string sequence = scratch.file(
      "sequence.yaml",
      scene_of("sequence: {frames: 2, vary: {surfaces.red.texture: [{pattern: bands}, {pattern: "
               "bands}], board.ram: [1, 2]}}\n"));
  const Outcome outcome =
      run_maquette("run " + sequence + " --outdir " + (scratch / "no").string());
  CHECK(outcome.exit_code == 2);
  CHECK_THAT(outcome.errors, ContainsSubstring("board"));
  CHECK_FALSE(std::filesystem::exists(scratch / "no"));
}

}  // namespace
