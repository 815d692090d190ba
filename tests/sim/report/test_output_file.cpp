#include "sim/report/output_file.hpp"

#include <string>

#include "sim/report/run_directory.hpp"
#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

namespace maquette::sim {
namespace {

namespace fs = std::filesystem;
using tests::ScratchDirectory;

std::ptrdiff_t files_in(const fs::path& directory) {
  return std::distance(fs::directory_iterator(directory), fs::directory_iterator());
}

}  // namespace

TEST_CASE("a file has its name and its content when it is published, and not before") {
  const ScratchDirectory scratch;
  const fs::path path = scratch.path() / "file";
  {
    OutputFile file(path);
    file.stream() << "one\n" << '\0' << "two";
    CHECK_FALSE(fs::exists(path));
    file.publish();
    CHECK(read_file(path) == std::string("one\n\0two", 8));
  }
  CHECK(files_in(scratch.path()) == 1);
}

TEST_CASE("a file that is not published leaves nothing, and what had its name stays") {
  const ScratchDirectory scratch;
  const fs::path path = scratch.path() / "file";
  {
    OutputFile file(path);
    file.stream() << "first";
    file.publish();
  }
  { OutputFile(path).stream() << "second"; }
  CHECK(read_file(path) == "first");
  CHECK(files_in(scratch.path()) == 1);
  OutputFile third(path);
  third.stream() << "third";
  third.publish();
  CHECK(read_file(path) == "third");
}

TEST_CASE("a file that cannot be is refused when it is begun, with its name") {
  const ScratchDirectory scratch;
  CHECK_THROWS_WITH(
      OutputFile(scratch.path() / "none" / "file"),
      Catch::Matchers::ContainsSubstring("none/file: cannot be written: No such file"));
  CHECK_THROWS_WITH(OutputFile(scratch.path()),
                    Catch::Matchers::ContainsSubstring("a directory has this name"));
  CHECK_THROWS_AS(OutputFile("/dev/null/file"), DescriptionError);
}

TEST_CASE("a file that cannot be written to its end is told when it is published") {
  const ScratchDirectory scratch;
  OutputFile failed(scratch.path() / "failed");
  failed.stream().setstate(std::ios::badbit);
  CHECK_THROWS_AS(failed.publish(), DescriptionError);
  CHECK_FALSE(fs::exists(scratch.path() / "failed"));
  OutputFile taken(scratch.path() / "taken");
  fs::create_directory(scratch.path() / "taken");
  CHECK_THROWS_AS(taken.publish(), DescriptionError);
  CHECK(fs::is_directory(scratch.path() / "taken"));
}

}  // namespace maquette::sim
