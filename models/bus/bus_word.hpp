#pragma once

#include <cstddef>
#include <cstdint>

namespace maquette::models {

/// Bytes as a word on the data lines: the first in the highest place, as the 68000 has it.
inline std::uint32_t word_of(const unsigned char* bytes, std::size_t count) {
  constexpr unsigned k_bits_per_byte = 8;
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < count; ++i) {
    word = word << k_bits_per_byte | bytes[i];
  }
  return word;
}

/// A word's bytes.
inline void put_word(std::uint32_t word, unsigned char* bytes, std::size_t count) {
  constexpr unsigned k_bits_per_byte = 8;
  for (std::size_t i = count; i-- > 0; word >>= k_bits_per_byte) {
    bytes[i] = static_cast<unsigned char>(word);
  }
}

}  // namespace maquette::models
