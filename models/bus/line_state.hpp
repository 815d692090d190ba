#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace maquette::models {

/// What a line of the backplane shows from the kernel's present instant on; the lines of an
/// address, or of a word, go together. A name that ends in _n is active low, as the signal with a
/// star is on the backplane.
struct LineState {
  int line;  ///< its number on its backplane, from 0
  const std::string& name;
  int bits;
  std::uint64_t value;  ///< of a single line 0 when it is low and 1 when it is high
};

using LineObserver = std::function<void(const LineState&)>;

}  // namespace maquette::models
