#include "models/board/mc68000/native_calls.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

namespace maquette::models::mc68000 {

void NativeCalls::add(std::uint32_t address, Function function) {
  if (address % 2 != 0 || address > 0xff'ffff) {
    throw std::invalid_argument("a native call needs an even address of 24 bits");
  }
  if (contains(address)) {
    throw std::invalid_argument("a native call has an address that is taken");
  }
  if (functions_.size() == std::numeric_limits<std::uint8_t>::max()) {
    throw std::invalid_argument("there are at most 255 native calls");
  }
  functions_.push_back(std::move(function));
  const std::size_t word = address / 2;
  numbers_.resize(std::max(numbers_.size(), word + 1));
  numbers_[word] = static_cast<std::uint8_t>(functions_.size());
}

}  // namespace maquette::models::mc68000
