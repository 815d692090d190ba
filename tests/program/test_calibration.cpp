#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;

namespace {

double synthesis_time(const ScratchDirectory& scratch, const std::string& scene,
                      const std::string& processor, const std::string& arithmetic) {
  const std::string directory = (scratch / (processor + arithmetic)).string();
  const Outcome outcome =
      run_maquette("run " + std::string(MAQUETTE_PROJECT_DIRECTORY) + "/scenes/" + scene +
                   " --processor " + processor + " --set board.arithmetic=" + arithmetic +
                   " --set 'frame_memory.width=96 pixels' --set 'frame_memory.height=72 pixels'"
                   " --set 'board.ram=1024 KiB' --quiet --outdir " +
                   directory);
  INFO(scene << ": " << outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return nlohmann::json::parse(content_of(directory + "/stats.json"))["frame"]["synthesis_s"];
}

TEST_CASE("calibrated counts come within a hundredth of the executed program") {
  const ScratchDirectory scratch;
  for (const std::string scene :
       {"photo1.yaml", "photo3.yaml", "photo4.yaml", "primitives/cone.yaml",
        "primitives/revolution.yaml", "primitives/torus.yaml"}) {
    for (const std::string arithmetic : {"motorola_ffp", "maquette_ffp", "ieee_single"}) {
      const double executed = synthesis_time(scratch, scene, "instruction", arithmetic);
      const double calibrated = synthesis_time(scratch, scene, "calibrated", arithmetic);
      INFO(scene << " " << arithmetic << ": " << calibrated << " s for " << executed << " s");
      CHECK(std::abs(calibrated / executed - 1) < 0.01);
    }
  }
}

}  // namespace
