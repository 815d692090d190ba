#include <string>
#include <vector>

#include "tests/catch.hpp"
#include "tests/models/board/mc68000/recording_bus.hpp"
#include "tests/models/board/mc68000/small_board.hpp"

namespace {

using namespace maquette::tests;
using namespace maquette::models::mc68000;
using Kind = BusRequest::Kind;

constexpr std::uint32_t k_program = 0x1000;
constexpr std::uint32_t k_data = 0x40'2000;  // off the board, and so is its low word

/// A RAM that holds the program alone, and a bus behind which all data are.
struct Fixture {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(0x2000);
  RecordingBus bus;
  Mc68000 processor{{bytes.data(), static_cast<std::uint32_t>(bytes.size())}, bus};

  StopReason execute(const std::vector<unsigned>& words) {
    std::uint32_t address = k_program;
    for (const unsigned word : words) {
      bytes[address++] = static_cast<std::uint8_t>(word >> 8U);
      bytes[address++] = static_cast<std::uint8_t>(word);
    }
    for (auto& whole : processor.registers().general) whole = k_data;
    processor.registers().program_counter = k_program;
    return processor.step().reason;
  }
};

/// The accesses of data as "clock:kind place", the place counted from where the data are.
std::string accesses_of(const std::vector<unsigned>& words) {
  Fixture fixture;
  REQUIRE(fixture.execute(words) == StopReason::cycle_limit);
  std::string text;
  for (const BusRequest& request : fixture.bus.requests) {
    const char kind = request.kind == Kind::read ? 'r' : request.kind == Kind::write ? 'w' : 't';
    const auto place = static_cast<int>(request.address) - static_cast<int>(k_data);
    text += (text.empty() ? "" : " ") + std::to_string(request.before.cycles) + ":" + kind +
            std::to_string(place);
  }
  return text;
}

struct Example {
  const char* instruction;
  std::vector<unsigned> words;
  const char* accesses;
};

// The expected clocks follow from the order of bus cycles in the MC68000's microprogram (US patent
// 4,325,121), each of four clocks, and its idle clocks in between.
TEST_CASE("accesses fall where the microprogram has them") {
  const std::vector<Example> examples = {
      {"MOVE.W D1,(A0)", {0x3081}, "0:w0"},
      {"MOVE.W D1,(A0)+", {0x30c1}, "0:w0"},
      {"MOVE.W D1,-(A0)", {0x3101}, "4:w-2"},
      {"MOVE.W D1,8(A0)", {0x3141, 8}, "4:w8"},
      {"MOVE.W D1,8(A0,D2.W)", {0x3181, 0x2008}, "6:w8200"},
      {"MOVE.W D1,$402010", {0x33c1, 0x0040, 0x2010}, "8:w16"},
      {"MOVE.W (A1),$402010", {0x33d1, 0x0040, 0x2010}, "0:r0 8:w16"},
      {"MOVE.W #1,(A0)", {0x30bc, 1}, "4:w0"},
      {"MOVE.W (A1),D0", {0x3011}, "0:r0"},
      {"MOVE.B -(A1),D0", {0x1021}, "2:r-1"},
      {"MOVE.L (A1),(A0)", {0x2091}, "0:r0 4:r2 8:w0 12:w2"},
      {"MOVE.L D1,-(A0)", {0x2101}, "4:w-2 8:w-4"},
      {"MOVE.L 8(A1),4(A0)", {0x2169, 8, 4}, "4:r8 8:r10 16:w4 20:w6"},
      {"CLR.B (A0), which is read first", {0x4210}, "0:r0 8:w0"},
      {"CLR.L (A0)", {0x4290}, "0:r0 4:r2 12:w2 16:w0"},
      {"ADD.W D0,(A1)", {0xd151}, "0:r0 8:w0"},
      {"ADDI.L #1,8(A1)", {0x06a9, 0, 1, 8}, "12:r8 16:r10 24:w10 28:w8"},
      {"TAS (A0)", {0x4ad0}, "0:t0"},
      {"TAS -(A0)", {0x4ae0}, "2:t-1"},
      {"ST (A0)", {0x50d0}, "0:r0 8:w0"},
      {"BSET #1,(A0)", {0x08d0, 1}, "4:r0 12:w0"},
      {"ASL.W (A0)", {0xe1d0}, "0:r0 8:w0"},
      {"MULU (A0),D1", {0xc2d0}, "0:r0"},
      {"CMPM.W (A1)+,(A0)+", {0xb149}, "0:r0 4:r0"},
      {"ADDX.W -(A1),-(A0)", {0xd149}, "2:r-2 6:r-2 14:w-2"},
      {"ADDX.L -(A1),-(A0)", {0xd189}, "2:r-2 6:r-4 10:r-2 14:r-4 18:w-2 26:w-4"},
      {"MOVEM.L D0-D1,-(A0)", {0x48e0, 0xc000}, "4:w-2 8:w-4 12:w-6 16:w-8"},
      {"MOVEM.W D0-D1,8(A0)", {0x48a8, 0x0003, 8}, "8:w8 12:w10"},
      {"MOVEM.W (A0)+,D0-D1, which reads on", {0x4c98, 0x0003}, "4:r0 8:r2 12:r4"},
      {"MOVEP.W D1,8(A0)", {0x0388, 8}, "4:w8 8:w10"},
      {"JSR (A0)", {0x4e90}, "4:w-4 8:w-2"},
      {"BSR", {0x6100, 0x0100}, "2:w-4 6:w-2"},
      {"PEA 8(A0)", {0x4868, 8}, "8:w-4 12:w-2"},
      {"PEA $402010", {0x4879, 0x0040, 0x2010}, "8:w-4 12:w-2"},
      {"LINK A0,#-8", {0x4e50, 0xfff8}, "4:w-4 8:w-2"},
      {"UNLK A0", {0x4e58}, "0:r0 4:r2"},
      {"RTS", {0x4e75}, "0:r0 4:r2"},
      {"RTR", {0x4e77}, "0:r0 4:r2 8:r4"},
  };
  for (const Example& example : examples) {
    INFO(example.instruction);
    CHECK(accesses_of(example.words) == example.accesses);
  }
}

/// What a processor has used, as a part of an instruction's time.
InstructionCost total_of(const Account& account) {
  return {static_cast<unsigned>(account.cycles), static_cast<unsigned>(account.fetches),
          static_cast<unsigned>(account.reads), static_cast<unsigned>(account.writes)};
}

unsigned accesses(const InstructionCost& cost) { return cost.fetches + cost.reads + cost.writes; }

/// Idle clocks between two places of an instruction; negative when there are more accesses than
/// fit.
int idle_between(const InstructionCost& from, const InstructionCost& to) {
  return static_cast<int>(to.cycles - from.cycles) -
         4 * static_cast<int>(accesses(to) - accesses(from));
}

/// The accesses of one instruction in turn: nothing overlaps, nothing is lost, and all idle clocks
/// and accesses together are its time.
void check_places(const Fixture& fixture) {
  InstructionCost passed{};
  int idle = 0;
  for (const BusRequest& request : fixture.bus.requests) {
    REQUIRE(request.size != OperandSize::long_word);
    REQUIRE(request.before.cycles % 2 == 0);
    REQUIRE(request.before.fetches >= passed.fetches);
    REQUIRE(request.before.reads == passed.reads);
    REQUIRE(request.before.writes == passed.writes);
    const int gap = idle_between(passed, request.before);
    REQUIRE(gap >= 0);
    idle += gap;
    passed = request.before;
    if (request.kind != Kind::write) passed = passed + k_one_read;
    if (request.kind != Kind::read) passed = passed + k_one_write;
    if (request.kind == Kind::test_and_set) passed = passed + InstructionCost{k_modify_cycles};
  }
  const InstructionCost total = total_of(fixture.processor.account());
  REQUIRE(total.fetches >= passed.fetches);
  REQUIRE(total.reads == passed.reads);
  REQUIRE(total.writes == passed.writes);
  const int rest = idle_between(passed, total);
  REQUIRE(rest >= 0);
  const bool modifies = fixture.processor.account().bus_modifications != 0;
  CHECK(idle + rest + (modifies ? static_cast<int>(k_modify_cycles) : 0) ==
        idle_between({}, total));
}

TEST_CASE("accesses and idle clocks add up to the time of every instruction word") {
  unsigned with_data = 0;
  for (unsigned word = 0; word < 0x10000; ++word) {
    Fixture fixture;
    // Extension words lead to even places off the board, and are masks of three registers.
    if (fixture.execute({word, 0x4006, 0x4006, 0x4006, 0x4006}) != StopReason::cycle_limit) {
      continue;
    }
    INFO(std::hex << word);
    check_places(fixture);
    with_data += fixture.bus.requests.empty() ? 0 : 1;
  }
  CHECK(with_data > 20'000);
}

}  // namespace
