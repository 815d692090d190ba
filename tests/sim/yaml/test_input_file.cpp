#include "sim/yaml/input_file.hpp"

#include <sys/stat.h>

#include <fstream>
#include <string>
#include <thread>

#include "sim/yaml/description_error.hpp"
#include "tests/catch.hpp"
#include "tests/sim/scratch_directory.hpp"

using maquette::sim::DescriptionError;
using maquette::sim::read_input;

TEST_CASE("all bytes of a file are read, whatever they are") {
  const maquette::tests::ScratchDirectory scratch;
  for (const std::size_t size : {0U, 1U, 65'535U, 65'536U, 65'537U, 1'000'000U}) {
    std::string content(size, '\0');
    for (std::size_t i = 0; i < size; ++i) {
      content[i] = static_cast<char>(i * 7 + i / 256);
    }
    const std::string path = scratch.path() / "file";
    std::ofstream(path, std::ios::binary) << content;
    CHECK(read_input(path).path == path);
    CHECK(read_input(path).content == content);
  }
}

TEST_CASE("a pipe is read to its end") {
  const maquette::tests::ScratchDirectory scratch;
  const std::string path = scratch.path() / "pipe";
  REQUIRE(::mkfifo(path.c_str(), 0600) == 0);
  const std::string content(200'000, 'x');
  std::thread writer([&] { std::ofstream(path, std::ios::binary) << content; });
  CHECK(read_input(path).content == content);
  writer.join();
}

TEST_CASE("what is no file and what has no end are refused") {
  const maquette::tests::ScratchDirectory scratch;
  CHECK_THROWS_WITH(read_input(scratch.path() / "absent"),
                    Catch::Matchers::ContainsSubstring("cannot read the file"));
  CHECK_THROWS_AS(read_input(scratch.path()), DescriptionError);
  CHECK_THROWS_WITH(read_input("/dev/zero"),
                    Catch::Matchers::ContainsSubstring("more than 64 MiB"));
}
