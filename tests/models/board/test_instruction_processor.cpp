#include "models/board/instruction_processor.hpp"

#include <memory>
#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/models/machine/machine_run.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;
using Words = std::vector<std::uint16_t>;

constexpr std::uint32_t k_start = 0x1000;
constexpr std::uint16_t k_nop = 0x4E71;
constexpr PixelPosition k_pixel{3, 5};

/// MOVE.W #value, the address
void append_write(std::uint32_t address, std::uint32_t value, Words& words) {
  for (const std::uint32_t word : {0x33FCU, value & 0xFFFFU, address >> 16U, address & 0xFFFFU}) {
    words.push_back(static_cast<std::uint16_t>(word));
  }
}

/// ORI.W #value, the address, which reads before it writes
void append_or(std::uint32_t address, std::uint32_t value, Words& words) {
  append_write(address, value, words);
  words[words.size() - 4] = 0x0079;
}

/// So many NOPs, then a pixel of this colour, then STOP.
Words program_of(int nops, std::uint32_t rgb) {
  const std::uint32_t address = 0x800000 + 4 * (k_pixel.row * 64 + k_pixel.column);
  Words words(static_cast<std::size_t>(nops), k_nop);
  append_write(address, rgb >> 8U, words);
  append_write(address + 2, rgb << 8U, words);
  words.insert(words.end(), {0x4E72, 0x2700});
  return words;
}

FrameSetup setup_of(const Words& words) {
  RamPart part{k_start, {}};
  for (const std::uint16_t word : words) {
    part.bytes.push_back(static_cast<unsigned char>(word >> 8U));
    part.bytes.push_back(static_cast<unsigned char>(word));
  }
  FrameSetup setup = zone({k_pixel.column, k_pixel.row, 1, 1});
  setup.program = ProgramSetup{{k_start, 0x8000, 0x7000}, {}, 1, {{part}}};
  return setup;
}

TEST_CASE("an executed program takes its instructions, the RAM's waits and its bus accesses") {
  std::vector<std::unique_ptr<Run>> runs;
  for (const int nops : {0, 1, 1000}) {
    runs.push_back(std::make_unique<Run>("nops" + std::to_string(nops), machine(1),
                                         setup_of(program_of(nops, colour(k_pixel)))));
  }
  sc_core::sc_start();
  std::size_t run = 0;
  for (const int nops : {0, 1, 1000}) {
    const MachineStatistics statistics = runs[run++]->machine.statistics();
    // NOP: 4(1/0); MOVE.W #,xxx.L: 20(4/1), of which the write is the bus's; a fetch waits 2
    // clocks.
    const Duration program = (nops * (4 + 2) + 2 * (16 + 4 * 2)) * k_clock;
    const Duration accesses = 2 * (4 * k_clock + k_word);
    CHECK(statistics.frame_time == program + accesses);
    CHECK(statistics.boards[0].pixels == 1);
    CHECK(statistics.boards[0].words == 2);
    check_states(statistics);
    CHECK_NOTHROW(runs[run - 1]->machine.verify_frame());
  }
}

TEST_CASE("no access of an instruction is requested before the one before it has ended") {
  const std::uint32_t address = 0x800000 + 4 * (k_pixel.row * 64 + k_pixel.column);
  Words words;
  append_or(address, colour(k_pixel) >> 8U, words);
  append_or(address + 2, colour(k_pixel) << 8U, words);
  words.insert(words.end(), {0x4E72, 0x2700});
  Run run("twice", machine(1), setup_of(words));
  Instant end{};
  int accesses = 0;
  run.machine.observe_bus([&end, &accesses](const BusAccess& access) {
    CHECK(access.request >= end);
    end = access.end;
    ++accesses;
  });
  sc_core::sc_start();
  CHECK(accesses == 4);
  // ORI.W #,xxx.L: 24(5/1), with four fetches, a read and a write; the last two are the bus's.
  const MachineStatistics statistics = run.machine.statistics();
  CHECK(statistics.frame_time == 2 * (16 + 4 * 2) * k_clock + 4 * (4 * k_clock + k_word));
  check_states(statistics);
}

TEST_CASE("refresh stretches an executed program as it does counted work") {
  MachineParameters parameters = machine(1);
  parameters.board.refresh_period = Duration(15'000'000);
  parameters.board.refresh_clocks = 4;
  Run run("refresh", parameters, setup_of(program_of(10'000, colour(k_pixel))));
  sc_core::sc_start();
  const double clocks = 10'000 * 6 + 2 * 24;
  const double stretched = clocks * 120 / (120 - 4);  // 15 us are 120 clocks
  const Duration accesses = 2 * (4 * k_clock + k_word);
  const double computed =
      static_cast<double>((run.machine.statistics().frame_time - accesses).count());
  CHECK(computed == Approx(stretched * static_cast<double>(k_clock.count())).margin(2e5));
}

TEST_CASE("a program that has another pixel than the firmware, or goes wrong, ends the run") {
  const auto error_of = [](const std::string& name, const Words& words) {
    Run run(name, machine(1), setup_of(words));
    try {
      sc_core::sc_start();
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(error_of("other", program_of(0, colour(k_pixel) + 1)),
             Catch::Matchers::ContainsSubstring("another pixel (3, 5)"));
}

TEST_CASE("a program that goes wrong says where and why") {
  Run run("illegal", machine(1), setup_of({k_nop, 0xA123}));
  try {
    sc_core::sc_start();
    FAIL("the program stops");
  } catch (const std::exception& error) {
    CHECK_THAT(std::string(error.what()), Catch::Matchers::ContainsSubstring("0x1002"));
    CHECK_THAT(std::string(error.what()), Catch::Matchers::ContainsSubstring("0xa123"));
  }
}

}  // namespace
