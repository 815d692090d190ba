#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace maquette::models {

inline constexpr std::size_t k_long_bytes = 4;

/// Appends a long word as the 68000 stores it, its highest byte first.
inline void append_long(std::uint32_t value, std::vector<unsigned char>& bytes) {
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes.push_back(static_cast<unsigned char>(value >> shift));
  }
}

/// The long word in the first four bytes.
[[nodiscard]] inline std::uint32_t long_of(const std::vector<unsigned char>& bytes) {
  std::uint32_t value = 0;
  for (std::size_t byte = 0; byte < k_long_bytes; ++byte) {
    value = value << 8U | bytes[byte];
  }
  return value;
}

}  // namespace maquette::models
