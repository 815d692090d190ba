#include "models/board/mc68000/native_calls.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace maquette::models::mc68000 {

void NativeCalls::add(std::uint32_t address, Function function) {
  if (address % 2 != 0 || address > 0xff'ffff) {
    throw std::invalid_argument("a native call needs an even address of 24 bits");
  }
  if (!functions_.emplace(address, std::move(function)).second) {
    throw std::invalid_argument("a native call has an address that is taken");
  }
  const std::uint32_t word = address / 2;
  marks_.resize(std::max<std::size_t>(marks_.size(), word / 64 + 1));
  marks_[word / 64] |= std::uint64_t{1} << (word % 64);
}

}  // namespace maquette::models::mc68000
