#pragma once

#include <cstdint>

namespace maquette::firmware {

/// Product of two words: one instruction, where the compiler may call a routine.
inline std::uint32_t product(std::uint16_t a, std::uint16_t b) {
  std::uint32_t result = a;
  __asm__("mulu.w %1,%0" : "+d"(result) : "d"(b) : "cc");
  return result;
}

struct Quotient {
  std::uint16_t value;
  std::uint16_t remainder;
};

/// A long word divided by a word; the quotient must be one.
inline Quotient quotient(std::uint32_t dividend, std::uint16_t divisor) {
  __asm__("divu.w %1,%0" : "+d"(dividend) : "d"(divisor) : "cc");
  return {static_cast<std::uint16_t>(dividend), static_cast<std::uint16_t>(dividend >> 16U)};
}

}  // namespace maquette::firmware
