#pragma once

#include <string>
#include <vector>

#include "tests/models/board/mc68000/small_board.hpp"

namespace maquette::tests {

/// A time as the manual writes it: cycles(reads/writes), reads of the program included.
struct Time {
  unsigned cycles = 0;
  unsigned reads = 0;
  unsigned writes = 0;
};

inline Time time_from(const std::string& text) {
  const auto open = text.find('(');
  const auto slash = text.find('/');
  const auto number = [&text](std::size_t place) {
    return static_cast<unsigned>(std::stoul(text.substr(place)));
  };
  return {number(0), number(open + 1), number(slash + 1)};
}

inline Time operator+(Time a, Time b) {
  return {a.cycles + b.cycles, a.reads + b.reads, a.writes + b.writes};
}

inline std::string text_of(Time time) {
  return std::to_string(time.cycles) + "(" + std::to_string(time.reads) + "/" +
         std::to_string(time.writes) + ")";
}

/// An addressing mode with register 1, and words that lead it to even places in the RAM.
struct TimedMode {
  const char* name;
  unsigned field;
  std::vector<unsigned> words;       // of an operand of a byte or a word
  std::vector<unsigned> long_words;  // of one of a long word
};

inline const std::vector<TimedMode>& timed_modes() {
  static const std::vector<TimedMode> modes = {
      {"Dn", 001, {}, {}},
      {"An", 011, {}, {}},
      {"(An)", 021, {}, {}},
      {"(An)+", 031, {}, {}},
      {"-(An)", 041, {}, {}},
      {"d16(An)", 051, {0x0100}, {0x0100}},
      {"d8(An,Xn)", 061, {0x6010}, {0x6010}},
      {"xxx.W", 070, {0x4000}, {0x4000}},
      {"xxx.L", 071, {0x0000, 0x4000}, {0x0000, 0x4000}},
      {"d16(PC)", 072, {0x0100}, {0x0100}},
      {"d8(PC,Xn)", 073, {0x6010}, {0x6010}},
      {"#", 074, {0x0010}, {0x0000, 0x0010}},
  };
  return modes;
}

/// Executes an instruction in a state where every address is even and in the RAM, and returns its
/// time, or why it stopped.
inline std::string time_of(const std::vector<unsigned>& words) {
  SmallBoard board;
  for (unsigned number = 0; number < 8; ++number) board.a(number) = 0x5000 + 0x100 * number;
  board.d(6) = 0x20;
  board.poke(0x5700, 4, 0x0000'2000);  // what the stack holds
  board.poke(0x5704, 4, 0x2000'2000);
  std::uint32_t address = SmallBoard::k_program;
  for (const unsigned word : words) {
    board.poke(address, 2, word);
    address += 2;
  }
  board.registers().program_counter = SmallBoard::k_program;
  const Stop stop = board.processor().step();
  if (stop.reason != StopReason::cycle_limit) return models::mc68000::name_of(stop.reason);
  const Account& account = board.processor().account();
  return text_of({static_cast<unsigned>(account.cycles),
                  static_cast<unsigned>(account.fetches + account.reads),
                  static_cast<unsigned>(account.writes)});
}

}  // namespace maquette::tests
