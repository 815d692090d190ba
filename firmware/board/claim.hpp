#pragma once

#include <cstdint>

/// Units that boards share: a counter behind a lock in a memory on the bus.
namespace maquette::firmware {

/// Takes the next unit: the lock by TAS, the counter a long word behind it, which is left greater
/// by one, and gives the lock back. A board that finds the lock taken waits the longer the more
/// boards there are, so that they do not keep its holder off the bus.
inline std::uint32_t claimed_unit(std::uint32_t lock, std::uint32_t boards) {
  std::uint32_t unit = 0;
  std::uint32_t next = 0;
  std::uint32_t pause = 0;
  __asm__ volatile(
      "bra.s 2f\n"
      "1:\tmove.w %4,%2\n"
      "3:\tnop\n"
      "\tdbra %2,3b\n"
      "2:\ttas (%3)\n"
      "\tjmi 1b\n"
      "\tmove.l 4(%3),%0\n"
      "\tmove.l %0,%1\n"
      "\taddq.l #1,%1\n"
      "\tmove.l %1,4(%3)\n"
      "\tclr.b (%3)"
      : "=&d"(unit), "=&d"(next), "=&d"(pause)
      : "a"(lock), "d"(boards)
      : "cc", "memory");
  return unit;
}

}  // namespace maquette::firmware
