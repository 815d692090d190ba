#include "sim/page/picture_difference.hpp"

#include <algorithm>
#include <cstdlib>

namespace maquette::sim {
namespace {

int difference_of(std::uint32_t first, std::uint32_t second, unsigned shift) {
  return std::abs(static_cast<int>(first >> shift & 0xFFU) -
                  static_cast<int>(second >> shift & 0xFFU));
}

constexpr unsigned k_shifts[] = {16, 8, 0};

}  // namespace

models::Picture difference_picture(const models::Picture& first, const models::Picture& second) {
  int largest = 1;
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    for (const unsigned shift : k_shifts) {
      largest = std::max(largest, difference_of(first.pixels[i], second.pixels[i], shift));
    }
  }
  models::Picture picture{first.width, first.height, {}};
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    std::uint32_t pixel = 0;
    for (const unsigned shift : k_shifts) {
      const int difference = difference_of(first.pixels[i], second.pixels[i], shift);
      const int shown = difference == 0 ? 0 : 64 + 191 * difference / largest;
      pixel |= static_cast<std::uint32_t>(shown) << shift;
    }
    picture.pixels.push_back(pixel);
  }
  return picture;
}

}  // namespace maquette::sim
