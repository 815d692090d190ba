#include <string>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

namespace maquette::tests {
namespace {

/// The run directory of the small scene on a machine with overrides; it must run without a word.
std::filesystem::path run_with(const ScratchDirectory& scratch, const std::string& name,
                               const std::string& overrides) {
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  const auto directory = scratch / name;
  const Outcome outcome = run_maquette("run " + scene + k_small_frame + overrides +
                                       " --quiet --outdir " + directory.string());
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
  return directory;
}

TEST_CASE("what the boards share, and how many ports there are, leaves the picture as it is") {
  const ScratchDirectory scratch;
  const std::string plain = content_of(run_with(scratch, "plain", "") / "frame.png");
  const char* const machines[] = {
      "--set allotment.assignment=on_demand --set allotment.order=tiles",
      "--set board.database=shared",
      "--set 'board.database_cache=1 KiB' --set board.database=shared --set frame_memory.ports=2",
      "--set allotment.assignment=on_demand --set board.database=shared --set board.release=block "
      "--set board.pixel_write=line --set 'bus.data_width=32 bits'",
      "--set frame_memory.ports=4",
  };
  int number = 0;
  for (const char* machine : machines) {
    const auto first = run_with(scratch, "first" + std::to_string(number), machine);
    const auto again = run_with(scratch, "again" + std::to_string(number++), machine);
    INFO(machine);
    CHECK(content_of(first / "frame.png") == plain);
    CHECK(content_of(first / "stats.json") == content_of(again / "stats.json"));
  }
}

TEST_CASE("a shared database takes nothing of a board's RAM") {
  const ScratchDirectory scratch;
  const std::string scene = scratch.file("small.yaml", k_small_scene);
  CHECK(run_maquette("describe " + scene).output.find("bytes  database\n") != std::string::npos);
  CHECK(run_maquette("describe " + scene + " --set board.database=shared")
            .output.find("bytes  database\n") == std::string::npos);
}

TEST_CASE("units on demand on several backplanes are refused") {
  const ScratchDirectory scratch;
  const Outcome outcome =
      run_maquette("run " + scratch.file("small.yaml", k_small_scene) +
                   " --set frame_memory.ports=2 --set allotment.assignment=on_demand --outdir " +
                   (scratch / "out").string());
  CHECK(outcome.exit_code == 2);
  CHECK(outcome.errors.find("frame_memory.ports=1 only") != std::string::npos);
  CHECK_FALSE(std::filesystem::exists(scratch / "out"));
}

TEST_CASE("a trace shows every backplane") {
  const ScratchDirectory scratch;
  const std::string trace = (scratch / "trace.json").string();
  run_with(scratch, "out", "--set frame_memory.ports=2 --trace " + trace);
  const std::string text = content_of(trace);
  CHECK(text.find("versabus") != std::string::npos);
  CHECK(text.find("versabus1") != std::string::npos);
}

}  // namespace
}  // namespace maquette::tests
