#pragma once

#include <cstdint>

#include "models/board/mc68000/instruction_cost.hpp"

namespace maquette::models::mc68000 {

/// What a processor has used since it began. Wait states of its RAM are whatever the board makes of
/// the words counted here.
struct Account {
  std::uint64_t cycles = 0;  // without wait states, but with those that the bus replied
  std::uint64_t fetches = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;

  // What of the above was outside of the RAM.
  std::uint64_t bus_wait_cycles = 0;
  std::uint64_t bus_fetches = 0;
  std::uint64_t bus_reads = 0;
  std::uint64_t bus_writes = 0;
  std::uint64_t bus_modifications = 0;  // a read and a write each, in one bus cycle

  void add(const InstructionCost& cost) {
    cycles += cost.cycles;
    fetches += cost.fetches;
    reads += cost.reads;
    writes += cost.writes;
  }
};

}  // namespace maquette::models::mc68000
