#include "sim/report/output_check.hpp"

#include <sys/stat.h>

#include "sim/report/run_directory.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

using namespace maquette::sim;
using Catch::Matchers::ContainsSubstring;
using maquette::tests::ScratchDirectory;

namespace fs = std::filesystem;

TEST_CASE("outputs may be new, or take the place of files") {
  const ScratchDirectory scratch;
  write_files(scratch.path(), {{"old.json", "x"}, {"scene.yaml", "y"}});
  fs::create_symlink("old.json", scratch.path() / "link.json");
  const std::vector<InputFile> inputs{{scratch.path() / "scene.yaml", ""}};
  const fs::path run = scratch.path() / "run";
  for (const char* name : {"old.json", "new.json", "link.json", "none/new.json", "stats.json",
                           "run/trace.json", "run/frames.json", "run/below/stats.json"}) {
    INFO(name);
    CHECK_NOTHROW(check_outputs({{"--trace", scratch.path() / name}}, inputs, run));
  }
}

TEST_CASE("what a command reads or writes already is no output") {
  const ScratchDirectory scratch;
  write_files(scratch.path(), {{"scene.yaml", "y"}});
  const std::vector<InputFile> inputs{{scratch.path() / "scene.yaml", ""}};
  fs::create_symlink("scene.yaml", scratch.path() / "link.yaml");
  fs::create_directory(scratch.path() / "below");
  const fs::path run = scratch.path() / "run";
  const auto message = [&](std::vector<RequestedOutput> outputs) {
    try {
      check_outputs(outputs, inputs, run);
    } catch (const DescriptionError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const char* name : {"scene.yaml", "below/../scene.yaml", "./scene.yaml", "link.yaml"}) {
    CHECK_THAT(message({{"--trace", scratch.path() / name}}),
               ContainsSubstring("--trace ") && ContainsSubstring("the command reads this file"));
  }
  CHECK_THAT(message({{"--trace", scratch.path() / "a"}, {"--record", scratch.path() / "./a"}}),
             ContainsSubstring("--record ") && ContainsSubstring("written twice"));
  for (const char* name : {"stats.json", "config.yaml", "manifest.json", "frame.png", "depth.png",
                           "snapshot-1s.png", "frame-0001.png", "ram-0.bin", "ram.map"}) {
    INFO(name);
    CHECK_THAT(message({{"--trace", run / name}}), ContainsSubstring("a result of the run"));
    CHECK_THAT(message({{"--trace", run / "x" / ".." / name}}),
               ContainsSubstring("a result of the run"));
  }
}

TEST_CASE("only regular files are replaced") {
  const ScratchDirectory scratch;
  fs::create_directory(scratch.path() / "directory");
  fs::create_symlink("nowhere", scratch.path() / "link");
  fs::create_symlink("/dev/null", scratch.path() / "device");
  REQUIRE(::mkfifo((scratch.path() / "pipe").c_str(), 0600) == 0);
  for (const char* name : {"directory", "link", "device", "pipe", "/dev/null"}) {
    INFO(name);
    CHECK_THROWS_WITH(check_outputs({{"--record", scratch.path() / name}}, {}, "run"),
                      ContainsSubstring("cannot be written"));
  }
}
