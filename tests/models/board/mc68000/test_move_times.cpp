#include "tests/catch.hpp"
#include "tests/models/board/mc68000/timed_board.hpp"

namespace {

using namespace maquette::tests;

// Tables 8-2 and 8-3 of the MC68000 User's Manual: sources downwards in the order of timed_modes(),
// destinations Dn, An, (An), (An)+, -(An), d16(An), d8(An,Xn), xxx.W, xxx.L across.
using Matrix = const char* const[12][9];

constexpr Matrix k_words = {
    {"4(1/0)", "4(1/0)", "8(1/1)", "8(1/1)", "8(1/1)", "12(2/1)", "14(2/1)", "12(2/1)", "16(3/1)"},
    {"4(1/0)", "4(1/0)", "8(1/1)", "8(1/1)", "8(1/1)", "12(2/1)", "14(2/1)", "12(2/1)", "16(3/1)"},
    {"8(2/0)", "8(2/0)", "12(2/1)", "12(2/1)", "12(2/1)", "16(3/1)", "18(3/1)", "16(3/1)",
     "20(4/1)"},
    {"8(2/0)", "8(2/0)", "12(2/1)", "12(2/1)", "12(2/1)", "16(3/1)", "18(3/1)", "16(3/1)",
     "20(4/1)"},
    {"10(2/0)", "10(2/0)", "14(2/1)", "14(2/1)", "14(2/1)", "18(3/1)", "20(3/1)", "18(3/1)",
     "22(4/1)"},
    {"12(3/0)", "12(3/0)", "16(3/1)", "16(3/1)", "16(3/1)", "20(4/1)", "22(4/1)", "20(4/1)",
     "24(5/1)"},
    {"14(3/0)", "14(3/0)", "18(3/1)", "18(3/1)", "18(3/1)", "22(4/1)", "24(4/1)", "22(4/1)",
     "26(5/1)"},
    {"12(3/0)", "12(3/0)", "16(3/1)", "16(3/1)", "16(3/1)", "20(4/1)", "22(4/1)", "20(4/1)",
     "24(5/1)"},
    {"16(4/0)", "16(4/0)", "20(4/1)", "20(4/1)", "20(4/1)", "24(5/1)", "26(5/1)", "24(5/1)",
     "28(6/1)"},
    {"12(3/0)", "12(3/0)", "16(3/1)", "16(3/1)", "16(3/1)", "20(4/1)", "22(4/1)", "20(4/1)",
     "24(5/1)"},
    {"14(3/0)", "14(3/0)", "18(3/1)", "18(3/1)", "18(3/1)", "22(4/1)", "24(4/1)", "22(4/1)",
     "26(5/1)"},
    {"8(2/0)", "8(2/0)", "12(2/1)", "12(2/1)", "12(2/1)", "16(3/1)", "18(3/1)", "16(3/1)",
     "20(4/1)"},
};

constexpr Matrix k_long_words = {
    {"4(1/0)", "4(1/0)", "12(1/2)", "12(1/2)", "12(1/2)", "16(2/2)", "18(2/2)", "16(2/2)",
     "20(3/2)"},
    {"4(1/0)", "4(1/0)", "12(1/2)", "12(1/2)", "12(1/2)", "16(2/2)", "18(2/2)", "16(2/2)",
     "20(3/2)"},
    {"12(3/0)", "12(3/0)", "20(3/2)", "20(3/2)", "20(3/2)", "24(4/2)", "26(4/2)", "24(4/2)",
     "28(5/2)"},
    {"12(3/0)", "12(3/0)", "20(3/2)", "20(3/2)", "20(3/2)", "24(4/2)", "26(4/2)", "24(4/2)",
     "28(5/2)"},
    {"14(3/0)", "14(3/0)", "22(3/2)", "22(3/2)", "22(3/2)", "26(4/2)", "28(4/2)", "26(4/2)",
     "30(5/2)"},
    {"16(4/0)", "16(4/0)", "24(4/2)", "24(4/2)", "24(4/2)", "28(5/2)", "30(5/2)", "28(5/2)",
     "32(6/2)"},
    {"18(4/0)", "18(4/0)", "26(4/2)", "26(4/2)", "26(4/2)", "30(5/2)", "32(5/2)", "30(5/2)",
     "34(6/2)"},
    {"16(4/0)", "16(4/0)", "24(4/2)", "24(4/2)", "24(4/2)", "28(5/2)", "30(5/2)", "28(5/2)",
     "32(6/2)"},
    {"20(5/0)", "20(5/0)", "28(5/2)", "28(5/2)", "28(5/2)", "32(6/2)", "34(6/2)", "32(6/2)",
     "36(7/2)"},
    {"16(4/0)", "16(4/0)", "24(4/2)", "24(4/2)", "24(4/2)", "28(5/2)", "30(5/2)", "28(5/2)",
     "32(6/2)"},
    {"18(4/0)", "18(4/0)", "26(4/2)", "26(4/2)", "26(4/2)", "30(5/2)", "32(5/2)", "30(5/2)",
     "34(6/2)"},
    {"12(3/0)", "12(3/0)", "20(3/2)", "20(3/2)", "20(3/2)", "24(4/2)", "26(4/2)", "24(4/2)",
     "28(5/2)"},
};

void check(unsigned size, bool is_long, Matrix& matrix) {
  for (unsigned from = 0; from < 12; ++from) {
    for (unsigned to = 0; to < 9; ++to) {
      const bool byte_of_address = size == 0x1000 && (from == 1 || to == 1);
      if (byte_of_address) continue;
      const TimedMode& source = timed_modes()[from];
      const TimedMode& destination = timed_modes()[to];
      const unsigned upper = (destination.field & 7U) << 9U | (destination.field >> 3U) << 6U;
      std::vector<unsigned> words{size | upper | source.field};
      const auto& source_words = is_long ? source.long_words : source.words;
      words.insert(words.end(), source_words.begin(), source_words.end());
      words.insert(words.end(), destination.words.begin(), destination.words.end());
      INFO(source.name << " to " << destination.name);
      CHECK(time_of(words) == matrix[from][to]);
    }
  }
}

TEST_CASE("MOVE of bytes and words takes the times of table 8-2") {
  check(0x1000, false, k_words);
  check(0x3000, false, k_words);
}

TEST_CASE("MOVE of long words takes the times of table 8-3") { check(0x2000, true, k_long_words); }

// Table 8-10, in the order of the modes.
constexpr const char* k_modes[] = {"(An)",  "(An)+", "-(An)",   "d16(An)",  "d8(An,Xn)",
                                   "xxx.W", "xxx.L", "d16(PC)", "d8(PC,Xn)"};

struct ModeRow {
  const char* name;
  std::vector<unsigned> words;
  std::vector<const char*> times;  // in the order of k_modes; nothing where the mode is none
};

TEST_CASE("JMP, JSR, LEA, PEA and MOVEM take the times of table 8-10") {
  const ModeRow rows[] = {
      {"JMP",
       {0x4ec0},
       {"8(2/0)", nullptr, nullptr, "10(2/0)", "14(3/0)", "10(2/0)", "12(3/0)", "10(2/0)",
        "14(3/0)"}},
      {"JSR",
       {0x4e80},
       {"16(2/2)", nullptr, nullptr, "18(2/2)", "22(3/2)", "18(2/2)", "20(3/2)", "18(2/2)",
        "22(3/2)"}},
      {"LEA",
       {0x45c0},
       {"4(1/0)", nullptr, nullptr, "8(2/0)", "12(2/0)", "8(2/0)", "12(3/0)", "8(2/0)", "12(2/0)"}},
      {"PEA",
       {0x4840},
       {"12(1/2)", nullptr, nullptr, "16(2/2)", "20(2/2)", "16(2/2)", "20(3/2)", "16(2/2)",
        "20(2/2)"}},
      {"MOVEM.W to 3 registers",
       {0x4c80, 0x0007},
       {"24(6/0)", "24(6/0)", nullptr, "28(7/0)", "30(7/0)", "28(7/0)", "32(8/0)", "28(7/0)",
        "30(7/0)"}},
      {"MOVEM.L to 3 registers",
       {0x4cc0, 0x0007},
       {"36(9/0)", "36(9/0)", nullptr, "40(10/0)", "42(10/0)", "40(10/0)", "44(11/0)", "40(10/0)",
        "42(10/0)"}},
      {"MOVEM.W of 3 registers",
       {0x4880, 0x0007},
       {"20(2/3)", nullptr, "20(2/3)", "24(3/3)", "26(3/3)", "24(3/3)", "28(4/3)", nullptr,
        nullptr}},
      {"MOVEM.L of 3 registers",
       {0x48c0, 0x0007},
       {"32(2/6)", nullptr, "32(2/6)", "36(3/6)", "38(3/6)", "36(3/6)", "40(4/6)", nullptr,
        nullptr}},
      {"MOVEM.W to no register",
       {0x4c80, 0},
       {"12(3/0)", "12(3/0)", nullptr, "16(4/0)", "18(4/0)", "16(4/0)", "20(5/0)", "16(4/0)",
        "18(4/0)"}},
      {"MOVEM.L of 16 registers",
       {0x48c0, 0xffff},
       {"136(2/32)", nullptr, "136(2/32)", "140(3/32)", "142(3/32)", "140(3/32)", "144(4/32)",
        nullptr, nullptr}},
  };
  for (const ModeRow& row : rows) {
    for (std::size_t index = 0; index < std::size(k_modes); ++index) {
      const TimedMode& mode = timed_modes()[index + 2];
      REQUIRE(std::string(mode.name) == k_modes[index]);
      std::vector<unsigned> words = row.words;
      words[0] |= mode.field;
      words.insert(words.end(), mode.words.begin(), mode.words.end());
      INFO(row.name << " " << mode.name);
      CHECK(time_of(words) ==
            (row.times[index] == nullptr ? "illegal instruction" : row.times[index]));
    }
  }
}

}  // namespace
