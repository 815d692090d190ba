#include "tests/catch.hpp"
#include "tests/models/board/mc68000/small_board.hpp"
#include "tests/models/board/mc68000/wide_arithmetic.hpp"

namespace {

using namespace maquette::tests;

// The conditions as the manual's table writes them.
bool holds(unsigned condition, unsigned codes) {
  const bool n = (codes & 8U) != 0;
  const bool z = (codes & 4U) != 0;
  const bool v = (codes & 2U) != 0;
  const bool c = (codes & 1U) != 0;
  const bool truths[] = {true,
                         false,
                         !c && !z,
                         c || z,
                         !c,
                         c,
                         !z,
                         z,
                         !v,
                         v,
                         !n,
                         n,
                         (n && v) || (!n && !v),
                         (n && !v) || (!n && v),
                         (n && v && !z) || (!n && !v && !z),
                         z || (n && !v) || (!n && v)};
  return truths[condition];
}

TEST_CASE("Bcc follows all conditions, by bytes and words, forwards and back") {
  SmallBoard board;
  for (unsigned condition = 2; condition < 16; ++condition) {
    for (unsigned codes = 0; codes < 32; ++codes) {
      const bool taken = holds(condition, codes);
      for (const int displacement : {2, 126, -2, -128, 4, -126}) {
        board.set_codes(codes);
        board.execute({0x6000U | condition << 8U | (static_cast<unsigned>(displacement) & 0xffU)});
        const auto there = static_cast<std::uint32_t>(0x1002 + displacement);
        REQUIRE(board.registers().program_counter == (taken ? there : 0x1002));
        REQUIRE(board.codes() == codes);
      }
      for (const int displacement : {2, 0x7ffe, -2, -0x1002, 0x100}) {
        board.set_codes(codes);
        board.execute({0x6000U | condition << 8U, static_cast<unsigned>(displacement) & 0xffffU});
        const auto there = static_cast<std::uint32_t>(0x1002 + displacement);
        REQUIRE(board.registers().program_counter == (taken ? there : 0x1004));
      }
    }
  }
}

TEST_CASE("BRA always goes, BSR leaves its return address") {
  SmallBoard board;
  board.execute({0x6010});
  CHECK(board.registers().program_counter == 0x1012);
  board.execute({0x6000, 0xfffe});
  CHECK(board.registers().program_counter == 0x1000);
  board.execute({0x6110});
  CHECK(board.registers().program_counter == 0x1012);
  CHECK(board.a(7) == 0x7ffc);
  CHECK(board.peek(0x7ffc, 4) == 0x1002);
  board.execute({0x6100, 0x0100});
  CHECK(board.registers().program_counter == 0x1102);
  CHECK(board.peek(0x7ff8, 4) == 0x1004);
}

TEST_CASE("DBcc counts down a word until its condition holds or it passes zero") {
  SmallBoard board;
  for (unsigned condition = 0; condition < 16; ++condition) {
    for (unsigned codes = 0; codes < 32; ++codes) {
      for (const unsigned counter : {0U, 1U, 0x8000U, 0xffffU}) {
        board.set_codes(codes);
        board.d(5) = 0x1234'0000U | counter;
        board.execute({0x50c8U | condition << 8U | 5U, 0x0020});
        const bool ended = holds(condition, codes);
        const unsigned after = ended ? counter : (counter - 1) & 0xffffU;
        REQUIRE(board.d(5) == (0x1234'0000U | after));
        REQUIRE(board.registers().program_counter == (!ended && counter != 0 ? 0x1022U : 0x1004U));
        REQUIRE(board.codes() == codes);
      }
    }
  }
}

TEST_CASE("Scc sets a byte to all ones or zeros") {
  SmallBoard board;
  for (unsigned condition = 0; condition < 16; ++condition) {
    for (unsigned codes = 0; codes < 32; ++codes) {
      const unsigned byte = holds(condition, codes) ? 0xff : 0;
      board.set_codes(codes);
      board.d(0) = 0xaabb'cc55;
      board.execute({0x50c0U | condition << 8U});
      REQUIRE(board.d(0) == (0xaabb'cc00U | byte));
      board.a(0) = 0x4003;
      board.poke(0x4002, 2, 0x5555);
      board.execute({0x50d0U | condition << 8U});
      REQUIRE(board.peek(0x4002, 2) == (0x5500U | byte));
      REQUIRE(board.codes() == codes);
    }
  }
}

TEST_CASE("branches of later processors and to odd addresses stop") {
  SmallBoard board;
  CHECK(board.execute({0x60ff}).reason == StopReason::later_encoding);
  const Stop stop = board.execute({0x6003});
  CHECK(stop.reason == StopReason::odd_address);
  CHECK(stop.access_address == 0x1005);
  CHECK(stop.instruction_address == 0x1000);
  CHECK(board.registers().program_counter == 0x1000);
  board.d(0) = 0;  // DBF looks at its target even when it does not loop
  CHECK(board.execute({0x51c8, 0x0003}).reason == StopReason::odd_address);
  CHECK(board.execute({0x50c8, 0x0003}).reason == StopReason::cycle_limit);
  board.set_codes(0);
  CHECK(board.execute({0x6703}).reason == StopReason::cycle_limit);  // BEQ, not taken
}

}  // namespace
