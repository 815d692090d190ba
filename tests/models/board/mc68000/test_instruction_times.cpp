#include "models/board/mc68000/decoder_table.hpp"
#include "tests/catch.hpp"
#include "tests/models/board/mc68000/recording_bus.hpp"
#include "tests/models/board/mc68000/timed_board.hpp"

namespace {

using namespace maquette::tests;
using maquette::models::mc68000::decoder_table;

// Table 8-1 of the MC68000 User's Manual: what an operand adds, in the order of timed_modes().
constexpr const char* k_word_operands[] = {"0(0/0)",  "0(0/0)", "4(1/0)",  "4(1/0)",
                                           "6(1/0)",  "8(2/0)", "10(2/0)", "8(2/0)",
                                           "12(3/0)", "8(2/0)", "10(2/0)", "4(1/0)"};
constexpr const char* k_long_operands[] = {"0(0/0)",  "0(0/0)",  "8(2/0)",  "8(2/0)",
                                           "10(2/0)", "12(3/0)", "14(3/0)", "12(3/0)",
                                           "16(4/0)", "12(3/0)", "14(3/0)", "8(2/0)"};

/// A row of tables 8-4 to 8-9: the time with an operand in a register or, where there is one,
/// immediate, and the time that is added to that of an operand in memory.
struct Row {
  const char* name;
  std::vector<unsigned> words;  // with an effective address of zero in the first
  bool is_long;
  const char* in_register;  // Dn and An, as far as the instruction has them
  const char* immediate;    // in all, nothing where the instruction has none
  const char* in_memory;    // besides the operand
};

const Row k_rows[] = {
    // Table 8-4, standard instructions.
    {"ADD.B ea,Dn", {0xd000}, false, "4(1/0)", "8(2/0)", "4(1/0)"},
    {"ADD.W ea,Dn", {0xd040}, false, "4(1/0)", "8(2/0)", "4(1/0)"},
    {"ADD.L ea,Dn", {0xd080}, true, "8(1/0)", "16(3/0)", "6(1/0)"},
    {"ADD.B Dn,M", {0xd100}, false, nullptr, nullptr, "8(1/1)"},
    {"ADD.L Dn,M", {0xd180}, true, nullptr, nullptr, "12(1/2)"},
    {"ADDA.W", {0xd0c0}, false, "8(1/0)", "12(2/0)", "8(1/0)"},
    {"ADDA.L", {0xd1c0}, true, "8(1/0)", "16(3/0)", "6(1/0)"},
    {"SUB.W ea,Dn", {0x9040}, false, "4(1/0)", "8(2/0)", "4(1/0)"},
    {"SUB.L ea,Dn", {0x9080}, true, "8(1/0)", "16(3/0)", "6(1/0)"},
    {"SUB.W Dn,M", {0x9140}, false, nullptr, nullptr, "8(1/1)"},
    {"SUB.L Dn,M", {0x9180}, true, nullptr, nullptr, "12(1/2)"},
    {"SUBA.W", {0x90c0}, false, "8(1/0)", "12(2/0)", "8(1/0)"},
    {"SUBA.L", {0x91c0}, true, "8(1/0)", "16(3/0)", "6(1/0)"},
    {"AND.W ea,Dn", {0xc040}, false, "4(1/0)", "8(2/0)", "4(1/0)"},
    {"AND.L ea,Dn", {0xc080}, true, "8(1/0)", "16(3/0)", "6(1/0)"},
    {"AND.W Dn,M", {0xc140}, false, nullptr, nullptr, "8(1/1)"},
    {"AND.L Dn,M", {0xc180}, true, nullptr, nullptr, "12(1/2)"},
    {"OR.W ea,Dn", {0x8040}, false, "4(1/0)", "8(2/0)", "4(1/0)"},
    {"OR.L ea,Dn", {0x8080}, true, "8(1/0)", "16(3/0)", "6(1/0)"},
    {"OR.W Dn,M", {0x8140}, false, nullptr, nullptr, "8(1/1)"},
    {"OR.L Dn,M", {0x8180}, true, nullptr, nullptr, "12(1/2)"},
    {"EOR.B", {0xb100}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"EOR.L", {0xb180}, true, "8(1/0)", nullptr, "12(1/2)"},
    {"CMP.B", {0xb000}, false, "4(1/0)", "8(2/0)", "4(1/0)"},
    {"CMP.L", {0xb080}, true, "6(1/0)", "14(3/0)", "6(1/0)"},
    {"CMPA.W", {0xb0c0}, false, "6(1/0)", "10(2/0)", "6(1/0)"},
    {"CMPA.L", {0xb1c0}, true, "6(1/0)", "14(3/0)", "6(1/0)"},
    {"MULU by 0", {0xc0c0}, false, "38(1/0)", nullptr, "38(1/0)"},
    {"MULS by 0", {0xc1c0}, false, "38(1/0)", nullptr, "38(1/0)"},
    // Table 8-5, immediate instructions. ANDI.L takes 16 cycles like the others, not 14.
    {"ADDI.B", {0x0600, 1}, false, "8(2/0)", nullptr, "12(2/1)"},
    {"ADDI.L", {0x0680, 0, 1}, true, "16(3/0)", nullptr, "20(3/2)"},
    {"SUBI.W", {0x0440, 1}, false, "8(2/0)", nullptr, "12(2/1)"},
    {"SUBI.L", {0x0480, 0, 1}, true, "16(3/0)", nullptr, "20(3/2)"},
    {"ANDI.W", {0x0240, 1}, false, "8(2/0)", nullptr, "12(2/1)"},
    {"ANDI.L", {0x0280, 0, 1}, true, "16(3/0)", nullptr, "20(3/2)"},
    {"ORI.W", {0x0040, 1}, false, "8(2/0)", nullptr, "12(2/1)"},
    {"ORI.L", {0x0080, 0, 1}, true, "16(3/0)", nullptr, "20(3/2)"},
    {"EORI.W", {0x0a40, 1}, false, "8(2/0)", nullptr, "12(2/1)"},
    {"EORI.L", {0x0a80, 0, 1}, true, "16(3/0)", nullptr, "20(3/2)"},
    {"CMPI.W", {0x0c40, 1}, false, "8(2/0)", nullptr, "8(2/0)"},
    {"CMPI.L", {0x0c80, 0, 1}, true, "14(3/0)", nullptr, "12(3/0)"},
    {"ADDQ.B", {0x5200}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"ADDQ.L", {0x5280}, true, "8(1/0)", nullptr, "12(1/2)"},
    {"SUBQ.B", {0x5300}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"SUBQ.L", {0x5380}, true, "8(1/0)", nullptr, "12(1/2)"},
    // Table 8-6, single operands. TAS takes 14(2/1) in all with (An).
    {"CLR.B", {0x4200}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"CLR.L", {0x4280}, true, "6(1/0)", nullptr, "12(1/2)"},
    {"NBCD", {0x4800}, false, "6(1/0)", nullptr, "8(1/1)"},
    {"NEG.W", {0x4440}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"NEG.L", {0x4480}, true, "6(1/0)", nullptr, "12(1/2)"},
    {"NEGX.W", {0x4040}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"NEGX.L", {0x4080}, true, "6(1/0)", nullptr, "12(1/2)"},
    {"NOT.W", {0x4640}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"NOT.L", {0x4680}, true, "6(1/0)", nullptr, "12(1/2)"},
    {"ST", {0x50c0}, false, "6(1/0)", nullptr, "8(1/1)"},
    {"SF", {0x51c0}, false, "4(1/0)", nullptr, "8(1/1)"},
    {"TAS", {0x4ac0}, false, "4(1/0)", nullptr, "10(1/1)"},
    {"TST.B", {0x4a00}, false, "4(1/0)", nullptr, "4(1/0)"},
    {"TST.L", {0x4a80}, true, "4(1/0)", nullptr, "4(1/0)"},
    // Table 8-7, shifts of memory.
    {"ASR M", {0xe0c0}, false, nullptr, nullptr, "8(1/1)"},
    {"ROXL M", {0xe5c0}, false, nullptr, nullptr, "8(1/1)"},
    {"ROL M", {0xe7c0}, false, nullptr, nullptr, "8(1/1)"},
    // Table 8-8, bits; of a register, those below 16.
    {"BCHG Dn", {0x0140}, false, "6(1/0)", nullptr, "8(1/1)"},
    {"BCHG #", {0x0840, 3}, false, "10(2/0)", nullptr, "12(2/1)"},
    {"BCLR Dn", {0x0180}, false, "8(1/0)", nullptr, "8(1/1)"},
    {"BCLR #", {0x0880, 3}, false, "12(2/0)", nullptr, "12(2/1)"},
    {"BSET Dn", {0x01c0}, false, "6(1/0)", nullptr, "8(1/1)"},
    {"BSET #", {0x08c0, 3}, false, "10(2/0)", nullptr, "12(2/1)"},
    {"BTST Dn", {0x0100}, false, "6(1/0)", "10(2/0)", "4(1/0)"},
    {"BTST #", {0x0800, 3}, false, "10(2/0)", nullptr, "8(2/0)"},
    // Table 8-9 and 8-12.
    {"CHK", {0x4180}, false, "10(1/0)", "14(2/0)", "10(1/0)"},
    {"MOVE from SR", {0x40c0}, false, "6(1/0)", nullptr, "8(1/1)"},
    {"MOVE to CCR", {0x44c0}, false, "12(1/0)", "16(2/0)", "12(1/0)"},
};

// With An the code of EOR is CMPM's, that of the bit instructions MOVEP's, and that of Scc DBcc's;
// ADDQ and SUBQ have rows below.
bool is_another_with_address_register(unsigned word) {
  const unsigned line = word >> 12U;
  return line == 0 || line == 5 || (line == 0xb && (word & 0x100U) != 0 && (word & 0xc0U) != 0xc0);
}

TEST_CASE("instructions with an effective address take the times of tables 8-4 to 8-9") {
  unsigned instances = 0;
  for (const Row& row : k_rows) {
    for (unsigned index = 0; index < 12; ++index) {
      const TimedMode& mode = timed_modes()[index];
      const bool immediate = index == 11;
      const char* alone = index < 2 ? row.in_register : (immediate ? row.immediate : nullptr);
      std::vector<unsigned> words = row.words;
      words[0] |= mode.field;
      const bool in_memory = index >= 2 && !immediate;
      const bool legal = decoder_table().is_legal(static_cast<std::uint16_t>(words[0]));
      if (!legal || (!in_memory && alone == nullptr)) continue;
      if (index == 1 && is_another_with_address_register(words[0])) continue;
      const auto& extension = row.is_long ? mode.long_words : mode.words;
      words.insert(words.end(), extension.begin(), extension.end());
      const Time operand = time_from(row.is_long ? k_long_operands[index] : k_word_operands[index]);
      INFO(row.name << " " << mode.name);
      CHECK(time_of(words) == (in_memory ? text_of(time_from(row.in_memory) + operand) : alone));
      ++instances;
    }
  }
  CHECK(instances > 500);
}

struct Single {
  const char* name;
  std::vector<unsigned> words;
  const char* time;
};

TEST_CASE("other instructions take the times of tables 8-4 to 8-14") {
  const Single rows[] = {
      {"ADDQ.W An", {0x5249}, "8(1/0)"},
      {"ADDQ.L An", {0x5289}, "8(1/0)"},
      {"SUBQ.W An", {0x5349}, "8(1/0)"},
      {"MOVEQ", {0x7005}, "4(1/0)"},
      {"MULU #$ffff", {0xc0fc, 0xffff}, "74(2/0)"},
      {"MULS #$5555", {0xc1fc, 0x5555}, "74(2/0)"},
      {"DIVU #1", {0x80fc, 1}, "140(2/0)"},
      {"DIVS #1", {0x81fc, 1}, "154(2/0)"},
      {"LSL.B #3,Dn", {0xe708}, "12(1/0)"},
      {"ASR.W #8,Dn", {0xe040}, "22(1/0)"},
      {"ROXR.L #1,Dn", {0xe290}, "10(1/0)"},
      {"ROL.L Dn,Dn", {0xedb8}, "72(1/0)"},  // by 0x20
      {"BCHG #16,Dn", {0x0840, 16}, "12(2/0)"},
      {"BCLR #16,Dn", {0x0880, 16}, "14(2/0)"},
      {"BSET #16,Dn", {0x08c0, 16}, "12(2/0)"},
      {"BTST #16,Dn", {0x0800, 16}, "10(2/0)"},
      {"BCC.B taken", {0x6410}, "10(2/0)"},
      {"BCS.B not taken", {0x6510}, "8(1/0)"},
      {"BCC.W taken", {0x6400, 0x10}, "10(2/0)"},
      {"BCS.W not taken", {0x6500, 0x10}, "12(2/0)"},
      {"BRA.B", {0x6010}, "10(2/0)"},
      {"BRA.W", {0x6000, 0x10}, "10(2/0)"},
      {"BSR.B", {0x6110}, "18(2/2)"},
      {"BSR.W", {0x6100, 0x10}, "18(2/2)"},
      {"DBT", {0x50c8, 0x10}, "12(2/0)"},
      {"DBF, looping", {0x51ce, 0x10}, "10(2/0)"},
      {"DBF, expired", {0x51c8, 0x10}, "14(3/0)"},
      {"ADDX.W Dn", {0xd141}, "4(1/0)"},
      {"ADDX.L Dn", {0xd181}, "8(1/0)"},
      {"ADDX.W M", {0xd149}, "18(3/1)"},
      {"ADDX.L M", {0xd189}, "30(5/2)"},
      {"SUBX.B M", {0x9109}, "18(3/1)"},
      {"SUBX.L M", {0x9189}, "30(5/2)"},
      {"CMPM.B", {0xb109}, "12(3/0)"},
      {"CMPM.L", {0xb189}, "20(5/0)"},
      {"ABCD Dn", {0xc101}, "6(1/0)"},
      {"ABCD M", {0xc109}, "18(3/1)"},
      {"SBCD Dn", {0x8101}, "6(1/0)"},
      {"SBCD M", {0x8109}, "18(3/1)"},
      {"ANDI to CCR", {0x023c, 0}, "20(3/0)"},
      {"EORI to SR", {0x0a7c, 0}, "20(3/0)"},
      {"MOVE to SR", {0x46fc, 0x2700}, "16(2/0)"},
      {"EXG", {0xc141}, "6(1/0)"},
      {"EXT.W", {0x4880}, "4(1/0)"},
      {"EXT.L", {0x48c0}, "4(1/0)"},
      {"LINK", {0x4e56, 0xfff0}, "16(2/2)"},
      {"MOVE from USP", {0x4e68}, "4(1/0)"},
      {"MOVE to USP", {0x4e60}, "4(1/0)"},
      {"NOP", {0x4e71}, "4(1/0)"},
      {"RTE", {0x4e73}, "20(5/0)"},
      {"RTR", {0x4e77}, "20(5/0)"},
      {"RTS", {0x4e75}, "16(4/0)"},
      {"SWAP", {0x4840}, "4(1/0)"},
      {"TRAPV", {0x4e76}, "4(1/0)"},
      {"UNLK", {0x4e5e}, "12(3/0)"},
      {"MOVEP.W of a register", {0x0189, 0}, "16(2/2)"},
      {"MOVEP.L of a register", {0x01c9, 0}, "24(2/4)"},
      {"MOVEP.W to a register", {0x0109, 0}, "16(4/0)"},
      {"MOVEP.L to a register", {0x0149, 0}, "24(6/0)"},
  };
  for (const Single& row : rows) {
    INFO(row.name);
    CHECK(time_of(row.words) == row.time);
  }
}

TEST_CASE("what is charged of data is what goes over the bus, for every instruction word") {
  RecordingBus bus;
  unsigned executed = 0;
  for (unsigned word = 0; word < 0x10000; ++word) {
    std::vector<std::uint8_t> none(2);
    Mc68000 processor({none.data(), 0}, bus);
    bus.memory.clear();
    bus.requests.clear();
    bus.cycles.clear();
    bus.memory[0x1000] = static_cast<std::uint8_t>(word >> 8U);
    bus.memory[0x1001] = static_cast<std::uint8_t>(word);
    bus.memory[0x1003] = 0x06;  // extension words are even, and masks of two registers
    bus.memory[0x1005] = 0x06;
    for (auto& whole : processor.registers().general) whole = 0x4000;
    processor.registers().program_counter = 0x1000;
    if (processor.step().reason != StopReason::cycle_limit) continue;
    const Account& account = processor.account();
    INFO(std::hex << word);
    REQUIRE(account.reads == account.bus_reads);
    REQUIRE(account.writes == account.bus_writes);
    REQUIRE(account.fetches >= account.bus_fetches);
    REQUIRE(account.cycles >= 4 * (account.fetches + account.reads + account.writes));
    ++executed;
  }
  CHECK(executed > 43'000);  // the others branch to odd addresses or stop
}

}  // namespace
