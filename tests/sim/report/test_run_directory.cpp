#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <map>

#include "sim/report/run_directory.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

using maquette::sim::create_run_directory;
using maquette::sim::DescriptionError;
using maquette::sim::NamedContent;
using maquette::sim::read_file;
using maquette::sim::write_files;
using maquette::tests::ScratchDirectory;

namespace fs = std::filesystem;

namespace {

std::map<std::string, std::string> contents(const fs::path& directory) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(directory)) {
    files[entry.path().filename().string()] = entry.is_directory() ? "" : read_file(entry.path());
  }
  return files;
}

}  // namespace

TEST_CASE("a set of files is written whole, over older ones, and nothing besides") {
  const ScratchDirectory scratch;
  const fs::path directory = scratch.path() / "deep" / "run";
  create_run_directory(directory);
  CHECK(contents(directory).empty());
  const std::string bytes("a\0b\r\n\xff", 6);
  write_files(directory, {{"one", "old"}, {"kept", "as it was"}});
  write_files(directory, {{"one", bytes}, {"two", ""}});
  CHECK(contents(directory) ==
        std::map<std::string, std::string>{{"kept", "as it was"}, {"one", bytes}, {"two", ""}});
  create_run_directory(directory);
  CHECK(contents(directory).size() == 3);
}

TEST_CASE("a set that cannot be written leaves the directory as it was") {
  const ScratchDirectory scratch;
  write_files(scratch.path(), {{"one", "old"}});
  const auto before = contents(scratch.path());

  SECTION("because the disk takes no more") {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, RLIM_INFINITY};
    REQUIRE(setrlimit(RLIMIT_FSIZE, &limit) == 0);
    CHECK_THROWS_AS(write_files(scratch.path(), {{"one", "new"}, {"two", std::string(5000, 'x')}}),
                    DescriptionError);
  }
  SECTION("because a directory has the name of a file") {
    fs::create_directory(scratch.path() / "two");
    CHECK_THROWS_AS(write_files(scratch.path(), {{"one", "new"}, {"two", "new"}}),
                    DescriptionError);
    fs::remove(scratch.path() / "two");
  }
  SECTION("because a name lies in a directory that is not there") {
    CHECK_THROWS_AS(write_files(scratch.path(), {{"one", "new"}, {"none/two", "new"}}),
                    DescriptionError);
  }
  CHECK(contents(scratch.path()) == before);
}

TEST_CASE("a directory that cannot be used is refused at once") {
  const ScratchDirectory scratch;
  write_files(scratch.path(), {{"file", "x"}});
  CHECK_THROWS_AS(create_run_directory(scratch.path() / "file"), DescriptionError);
  CHECK_THROWS_AS(create_run_directory(scratch.path() / "file" / "below"), DescriptionError);
  CHECK_THROWS_AS(create_run_directory("/proc/maquette"), DescriptionError);
  CHECK_THROWS_AS(create_run_directory("/proc"), DescriptionError);
  CHECK(contents(scratch.path()) == std::map<std::string, std::string>{{"file", "x"}});
}

TEST_CASE("a file that cannot be read is refused with its name") {
  const ScratchDirectory scratch;
  CHECK_THROWS_WITH(read_file(scratch.path() / "none"),
                    Catch::Matchers::ContainsSubstring("none: cannot be read"));
  CHECK_THROWS_AS(read_file(scratch.path()), DescriptionError);
}
