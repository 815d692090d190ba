#pragma once

namespace maquette::models {

/// A byte after the 68000's test-and-set cycle has read it (MC68000 TAS).
constexpr unsigned char taken(unsigned char byte) {
  constexpr unsigned char k_taken = 0x80;
  return static_cast<unsigned char>(byte | k_taken);
}

}  // namespace maquette::models
