#include "sim/run/interruption.hpp"
#include "sim/sweep/study_description.hpp"
#include "sim/sweep/study_results.hpp"
#include "sim/sweep/study_run.hpp"
#include "sim/yaml/description_error.hpp"
#include "sim/yaml/yaml_reader.hpp"
#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::sim;
using namespace maquette::tests;

TEST_CASE("a point that fails is stored with its reason and the others go on") {
  const Interruption interruption;
  const ScratchDirectory scratch;
  Study study;
  study.name = "failing";
  study.scene = parse_yaml(k_small_scene, "small.yaml");
  study.changes = {parse_override("frame_memory.width=32pixels"),
                   parse_override("frame_memory.height=24pixels")};
  study.axes = {parse_axis("board.ram=128KiB,40KiB,96KiB")};
  std::vector<maquette::sim::InputFile> input_files;
  inline_files(study, MAQUETTE_PROJECT_DIRECTORY, input_files);
  const StudyPoints points(study, MAQUETTE_PROJECT_DIRECTORY);
  CHECK_THROWS_AS(static_cast<void>(check_points(points)),
                  DescriptionError);  // the second board is too small

  const StudyDirectory directory(points, scratch / "out");
  int shown = 0;
  const StudyProgress progress = run_points(points, directory, {"a", "b", "a"}, {0, 1, 2}, 2,
                                            [&shown](const StudyProgress&) { ++shown; });
  CHECK(shown == 3);
  CHECK((progress.done == 3 && progress.failed == 1 && progress.planned == 3));
  CHECK(directory.is_finished(0));
  CHECK_FALSE(directory.is_finished(1));
  CHECK(directory.read(1)->failure.find("more than") != std::string::npos);
  CHECK(directory.is_finished(2));
  const StudyOutcome outcome = gather(points, directory);
  CHECK((outcome.done == 2 && outcome.failed == 1 && outcome.missing == 0));
}
