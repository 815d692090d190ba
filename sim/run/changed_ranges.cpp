#include "sim/run/changed_ranges.hpp"

#include <algorithm>

namespace maquette::sim {

std::vector<models::ImageRange> changed_ranges(const std::vector<unsigned char>& held,
                                               const std::vector<unsigned char>& image,
                                               std::size_t word_bytes) {
  std::vector<models::ImageRange> ranges;
  for (std::size_t first = 0; first < image.size(); first += word_bytes) {
    const std::size_t end = std::min(first + word_bytes, image.size());
    const bool is_held =
        end <= held.size() && std::equal(image.begin() + static_cast<std::ptrdiff_t>(first),
                                         image.begin() + static_cast<std::ptrdiff_t>(end),
                                         held.begin() + static_cast<std::ptrdiff_t>(first));
    if (is_held) {
      continue;
    }
    if (!ranges.empty() && ranges.back().end == first) {
      ranges.back().end = end;
    } else {
      ranges.push_back({first, end});
    }
  }
  return ranges;
}

}  // namespace maquette::sim
