#include <set>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

using namespace maquette::tests;
using Catch::Matchers::ContainsSubstring;

namespace {

Outcome run_small(const ScratchDirectory& scratch, const std::string& name,
                  const std::string& options) {
  return run_maquette("run " + scratch.file("small.yaml", k_small_scene) + " --quiet --outdir " +
                      (scratch / name).string() + k_small_frame + options);
}

void require_good(const Outcome& outcome) {
  INFO(outcome.errors);
  REQUIRE(outcome.exit_code == 0);
}

constexpr const char* k_maps =
    "--map time --map wait --map board --map written --map rays.reflected --map work.multiply "
    "--map function.photometry --map extents.met --map tree_depth --map surface --map distance "
    "--map normal.x ";

std::set<std::string> names_in(const std::filesystem::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

void check_same(const std::filesystem::path& a, const std::filesystem::path& b) {
  for (const std::string& name : names_in(a)) {
    if (name != "manifest.json") {
      INFO(name);
      CHECK(content_of(a / name) == content_of(b / name));
    }
  }
}

}  // namespace

TEST_CASE("Maps are the same bytes for any number of threads and from a record") {
  const ScratchDirectory scratch;
  const std::string record = " --record " + (scratch / "work.exr").string();
  require_good(run_small(scratch, "one", k_maps + std::string("--threads 1")));
  require_good(run_small(scratch, "three", k_maps + std::string("--threads 3") + record));
  require_good(
      run_small(scratch, "replayed", k_maps + std::string("--processor recorded") + record));
  CHECK(names_in(scratch / "one").size() == 4 + 1 + 12);
  check_same(scratch / "one", scratch / "three");
  check_same(scratch / "one", scratch / "replayed");
}

TEST_CASE("Maps change no other result, and go with a run that has none") {
  const ScratchDirectory scratch;
  require_good(run_small(scratch, "run", k_maps));
  CHECK(names_in(scratch / "run").count("maps.exr") == 1);
  require_good(run_small(scratch, "plain", ""));
  check_same(scratch / "plain", scratch / "run");
  require_good(run_small(scratch, "run", ""));
  CHECK(names_in(scratch / "run") == names_in(scratch / "plain"));
}

TEST_CASE("Maps that are none, or not of this run, are refused with what is allowed") {
  const ScratchDirectory scratch;
  const Outcome wrong = run_small(scratch, "run", "--map tiem");
  CHECK(wrong.exit_code == 2);
  CHECK_THAT(wrong.errors, ContainsSubstring("did you mean `time`?"));
  const Outcome counted = run_small(scratch, "run", "--map count_error");
  CHECK(counted.exit_code == 2);
  CHECK_THAT(counted.errors, ContainsSubstring("--processor instruction"));
  const Outcome frames = run_maquette(std::string("run ") + MAQUETTE_PROJECT_DIRECTORY +
                                      "/scenes/effects/swelling.yaml --map time --outdir " +
                                      (scratch / "run").string());
  CHECK(frames.exit_code == 2);
  CHECK_THAT(frames.errors, ContainsSubstring("--frame N"));
  CHECK_FALSE(std::filesystem::exists(scratch / "run"));
  CHECK_THAT(run_maquette("describe --maps").output, ContainsSubstring("rays.shadow"));
}
