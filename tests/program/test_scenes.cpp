#include <set>

#include "sim/primitives/primitive_table.hpp"
#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;

namespace {

const std::filesystem::path k_scenes = std::filesystem::path(MAQUETTE_PROJECT_DIRECTORY) / "scenes";

std::set<std::string> scenes_in(const std::string& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(k_scenes / folder)) {
    names.insert(entry.path().stem().string());
  }
  return names;
}

bool is_study(const std::filesystem::path& file) {
  return file.parent_path().filename() == "studies";
}

}  // namespace

TEST_CASE("Every primitive and every operator has a scene of its own") {
  std::set<std::string> primitives;
  for (const maquette::sim::PrimitiveDescription* primitive : maquette::sim::primitive_table()) {
    primitives.emplace(primitive->name);
  }
  CHECK(scenes_in("primitives") == primitives);
  CHECK(scenes_in("operators") == std::set<std::string>{"union", "intersection", "difference"});
}

TEST_CASE("Every shipped scene runs") {
  for (const auto& entry : std::filesystem::recursive_directory_iterator(k_scenes)) {
    if (entry.path().extension() != ".yaml" || is_study(entry.path())) {
      continue;
    }
    const ScratchDirectory scratch;
    const Outcome outcome = run_maquette("run " + entry.path().string() + k_small_frame +
                                         "--quiet --outdir " + (scratch / "out").string());
    INFO(entry.path() << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 0);
    CHECK(outcome.output.empty());
    CHECK((std::filesystem::exists(scratch / "out" / "frame.png") ||
           std::filesystem::exists(scratch / "out" / "frame-0000.png")));
  }
}

TEST_CASE("All points of every shipped study are sound, and the first one runs") {
  for (const auto& entry : std::filesystem::directory_iterator(k_scenes / "studies")) {
    if (entry.path().extension() != ".yaml") {
      continue;
    }
    const ScratchDirectory scratch;
    const Outcome outcome =
        run_maquette("sweep --sweep " + entry.path().string() + k_small_frame +
                     "--point 0 --quiet --outdir " + (scratch / "out").string());
    INFO(entry.path() << "\n" << outcome.errors);
    CHECK(outcome.exit_code == 0);
    CHECK(std::filesystem::exists(scratch / "out" / "points" / "000000.json"));
  }
}

TEST_CASE("What a scene does not need is left out") {
  const std::string describe = "describe " + (k_scenes / "primitives" / "box.yaml").string();
  const Outcome outcome = run_maquette(describe);
  REQUIRE(outcome.exit_code == 0);
  const std::size_t at = outcome.output.find("left out:");
  REQUIRE(at != std::string::npos);
  const std::string left_out = outcome.output.substr(at, outcome.output.find("\n\n", at) - at);
  for (const char* name : {"sphere", "cone", "transparency", "metals", "secondary rays"}) {
    INFO(name);
    CHECK(left_out.find(name) != std::string::npos);
  }
  CHECK(left_out.find("box") == std::string::npos);
}
