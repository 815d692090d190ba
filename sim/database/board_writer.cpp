#include "sim/database/board_writer.hpp"

namespace maquette::sim {

void BoardWriter::align(std::int64_t alignment) {
  if (alignment > 1) {
    position_ += position_ % 2;
  }
}

void BoardWriter::put(std::uint32_t value, std::size_t bytes) {
  constexpr unsigned k_byte_bits = 8;
  align(bytes > 1 ? 2 : 1);
  for (std::size_t byte = bytes; byte > 0; --byte) {
    ram_.at(position_++) = static_cast<unsigned char>(value >> k_byte_bits * (byte - 1));
  }
}

}  // namespace maquette::sim
