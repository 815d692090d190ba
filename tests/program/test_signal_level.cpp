#include <regex>

#include "tests/catch.hpp"
#include "tests/program/program.hpp"

namespace {

using namespace maquette::tests;

const char* const k_photo4 =
    "run " MAQUETTE_PROJECT_DIRECTORY "/scenes/photo4.yaml --quiet --threads 1 ";
const char* const k_coarse =
    "--set frame_memory.width=48pixels --set frame_memory.height=36pixels ";
const char* const k_coarsest =
    "--set frame_memory.width=8pixels --set frame_memory.height=6pixels ";

std::string without_level(const std::string& configuration) {
  return std::regex_replace(configuration, std::regex("level: (signal|transaction)"), "");
}

// A frame is the same to the byte, of whichever machine.
void check_same_frame(const std::string& machine) {
  INFO(machine);
  const ScratchDirectory scratch;
  for (const std::string level : {"transaction", "signal"}) {
    const Outcome run = run_maquette(k_photo4 + machine + " --bus " + level + " --outdir " +
                                     (scratch / level).string());
    INFO(run.errors);
    REQUIRE(run.exit_code == 0);
  }
  const auto content = [&scratch](const std::string& level, const std::string& file) {
    return content_of(scratch / level / file);
  };
  for (const std::string file : {"stats.json", "frame.png"}) {
    REQUIRE_FALSE(content("signal", file).empty());
    CHECK(content("signal", file) == content("transaction", file));
  }
  const std::string signal = content("signal", "config.yaml");
  const std::string transaction = content("transaction", "config.yaml");
  CHECK(signal != transaction);
  CHECK(without_level(signal) == without_level(transaction));
}

TEST_CASE("a frame on the bus's lines is that of its transactions") {
  check_same_frame(k_coarse);
  check_same_frame(std::string(k_coarse) + "--set processors=16 --set bus.arbitration=round_robin");
  check_same_frame(std::string(k_coarse) +
                   "--set processors=8 --set board.release=block --set board.pixel_write=line "
                   "--set \"bus.data_width=32 bits\" --set frame_memory.ports=2");
}

TEST_CASE("so is one whose boards share the database and claim their pixels") {
  check_same_frame(std::string(k_coarsest) +
                   "--set processors=3 --set board.database=shared "
                   "--set board.database_cache=8KiB --set allotment.assignment=on_demand");
}

TEST_CASE("so is one of boards faster than the access law of the data sheet knows") {
  check_same_frame(std::string(k_coarse) + "--set board.clock=512MHz --set processors=8");
}

TEST_CASE("so is one whose boards execute their program and claim their pixels") {
  check_same_frame(std::string(k_coarsest) +
                   "--processor instruction --set allotment.assignment=on_demand");
}

}  // namespace
