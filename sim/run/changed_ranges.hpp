#pragma once

#include <cstddef>
#include <vector>

#include "models/machine/ccett_machine.hpp"

namespace maquette::sim {

/// The parts of an image that differ from what memory holds, in whole words of a bus; what lies
/// behind the end of what it holds differs. Neighbours are one part.
[[nodiscard]] std::vector<models::ImageRange> changed_ranges(
    const std::vector<unsigned char>& held, const std::vector<unsigned char>& image,
    std::size_t word_bytes);

}  // namespace maquette::sim
