#include "firmware/board_functions.hpp"

#include <set>
#include <string>

#include "firmware_version.hpp"
#include "tests/catch.hpp"

using namespace maquette;

TEST_CASE("The program of a board is made from the firmware as it is") {
  INFO("after a change of the firmware tools/board_program makes it again");
  CHECK(std::string(firmware::k_board_firmware_version) == firmware::k_firmware_version);
}

TEST_CASE("The firmware for the 68000 asks for nothing but the arithmetic package") {
  const std::set<std::string> package = {
      "__addsf3", "__subsf3",  "__mulsf3",  "__divsf3",   "__ltsf2",   "__lesf2",     "__gtsf2",
      "__gesf2",  "__eqsf2",   "__nesf2",   "__unordsf2", "__fixsfsi", "__floatsisf", "sqrtf",
      "__mulsi3", "__udivsi3", "__umodsi3", "__divsi3",   "__modsi3",  "memcpy",      "memset"};
  for (const char* name : firmware::k_board_package_calls) {
    INFO(name);
    CHECK(package.count(name) == 1);
  }
}
