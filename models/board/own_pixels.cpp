#include "models/board/own_pixels.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "models/board/long_word.hpp"

namespace maquette::models {

OwnPixelClocks OwnPixels::clocks(const Kvm02Parameters& parameters) const {
  constexpr Clocks k_cycle = 4;
  const Clocks write = k_cycle + parameters.ram_write_wait_clocks;
  const Clocks read =
      compares_depth(display_.parameters()) ? k_cycle + parameters.ram_read_wait_clocks : 0;
  return {write, read + write};
}

void OwnPixels::keep(const PixelPosition& position, std::uint32_t written, Instant instant,
                     std::vector<unsigned char>& ram) const {
  if (store_.interlace.board_of(position) != board_) {
    throw std::logic_error("board" + std::to_string(board_) + " writes pixel (" +
                           std::to_string(position.column) + ", " + std::to_string(position.row) +
                           "), which is another's");
  }
  std::vector<unsigned char> bytes;
  append_long(written, bytes);
  std::copy(bytes.begin(), bytes.end(),
            ram.begin() + static_cast<std::ptrdiff_t>(store_.address_of(position)));
  display_.keep(position.column, position.row, written, instant);
}

}  // namespace maquette::models
