#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "tests/program/program.hpp"

using namespace maquette::tests;

TEST_CASE("The firmware for the 68000 asks for nothing but the arithmetic package") {
  const ScratchDirectory scratch;
  const std::string command = std::string("m68k-linux-gnu-nm --undefined-only --format=posix ") +
                              MAQUETTE_BOARD_OBJECT + " >" + (scratch / "names").string();
  REQUIRE(std::system(command.c_str()) == 0);
  const std::set<std::string> package = {
      "__addsf3", "__subsf3",  "__mulsf3",  "__divsf3",   "__ltsf2",   "__lesf2",     "__gtsf2",
      "__gesf2",  "__eqsf2",   "__nesf2",   "__unordsf2", "__fixsfsi", "__floatsisf", "sqrtf",
      "__mulsi3", "__udivsi3", "__umodsi3", "__divsi3",   "__modsi3",  "memcpy",      "memset"};
  std::istringstream lines(content_of(scratch / "names"));
  std::string line;
  int names = 0;
  while (std::getline(lines, line)) {
    const std::string name = line.substr(0, line.find(' '));
    INFO(name);
    CHECK(package.count(name) == 1);
    ++names;
  }
  CHECK(names >= 8);
}
