#include <nlohmann/json.hpp>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;

namespace {

/// Eleven panes of glass, between which each ray is followed by two: a pixel of 16 samples takes
/// the host some ten minutes.
std::string costly_scene() {
  std::string panes;
  for (int place = -5; place <= 6; ++place) {
    panes += place == 0 ? ""
                        : (panes.empty() ? "" : ", ") +
                              ("{box: {size: [90, 0.5, 90]}, place: {translate: [0, " +
                               std::to_string(place) + ", 0]}}");
  }
  return "view: {eye: [0, 0.02, 0], target: [0.1, 1, 0.03], field_of_view: 2 deg}\n"
         "surfaces: {glass: {specular: 1, transparent: true, index: 1.5}}\n"
         "ray_tree: {depth: 22, minimum_weight: 0}\n"
         "samples: {per_side: 4}\n"
         "object: {surface: glass, union: [" +
         panes + "]}\n";
}

struct Interrupted {
  int exit_code;
  double seconds;  ///< from the interruption to the end
};

/// Runs the scene and interrupts it when it is at work on a pixel.
Interrupted interrupt(const ScratchDirectory& scratch, const std::string& options) {
  const std::string command =
      std::string(MAQUETTE_PROGRAM) + " run " + scratch.file("costly.yaml", costly_scene()) +
      " --quiet --set 'frame_memory.width=2 pixels' --set 'frame_memory.height=1 pixels' "
      "--outdir " +
      (scratch / "run").string() + " " + options + " 2>/dev/null & pid=$!; until ls -d " +
      (scratch / ".run.unfinished-*").string() +
      " >/dev/null 2>&1 || ! kill -0 $pid; do sleep 0.02; done; sleep 0.7; kill -INT $pid; date "
      "+%s%N >" +
      (scratch / "begin").string() + "; wait $pid; code=$?; date +%s%N >" +
      (scratch / "end").string() + "; exit $code";
  const int status = std::system(command.c_str());
  const auto instant_s = [&scratch](const char* file) {
    return 1e-9 * std::stod(content_of(scratch / file));
  };
  return {WEXITSTATUS(status), instant_s("end") - instant_s("begin")};
}

/// A second is meant; a machine that is busy with other tests gets more.
constexpr double k_soon_s = 20;

}  // namespace

TEST_CASE("An interruption within a costly pixel ends the run with what there is") {
  const std::string tables = "--set board.costs=tables ";
  for (const std::string& options :
       {std::string(), tables, tables + "--threads 1", std::string("--processor instruction"),
        std::string("--processor recorded")}) {
    INFO(options);
    const ScratchDirectory scratch;
    const Interrupted run = interrupt(scratch, options);
    CHECK(run.exit_code == 130);
    CHECK(run.seconds < k_soon_s);
    const auto stats = nlohmann::json::parse(content_of(scratch / "run" / "stats.json"));
    CHECK(stats["partial"] == true);
    CHECK(stats["frame"]["pixels_synthesised"] < 2);
  }
}

TEST_CASE("A sweep that is interrupted while it makes the record of its points goes on later") {
  const ScratchDirectory scratch;
  const std::string command =
      std::string(MAQUETTE_PROGRAM) + " sweep " + scratch.file("costly.yaml", costly_scene()) +
      " --set 'frame_memory.width=2 pixels' --set 'frame_memory.height=1 pixels' "
      "--vary processors=1,2 --quiet --outdir " +
      (scratch / "study").string() + " 2>" + (scratch / "errors").string() +
      " & pid=$!; until [ -e " + (scratch / "study" / "study.yaml").string() +
      " ] || ! kill -0 $pid; do sleep 0.02; done; sleep 0.7; kill -INT $pid; wait $pid";
  const int status = std::system(command.c_str());
  CHECK(WEXITSTATUS(status) == 130);
  CHECK(content_of(scratch / "errors").find("interrupted after 0 of 2 points") !=
        std::string::npos);
}
