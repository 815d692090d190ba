#include "models/board/mc68000/stop.hpp"

#include <array>
#include <cstddef>

namespace maquette::models::mc68000 {

const char* name_of(StopReason reason) {
  constexpr std::array k_names{
      "limit of cycles",
      "stop address",
      "pause of the bus",
      "odd address",
      "bus error",
      "illegal instruction",
      "encoding of a later processor",
      "line A instruction",
      "line F instruction",
      "privilege violation",
      "trace",
      "division by zero",
      "CHK out of bounds",
      "TRAPV with overflow",
      "TRAP",
      "STOP",
      "RESET",
  };
  static_assert(k_names.size() == static_cast<std::size_t>(StopReason::reset_instruction) + 1);
  return k_names[static_cast<std::size_t>(reason)];
}

}  // namespace maquette::models::mc68000
