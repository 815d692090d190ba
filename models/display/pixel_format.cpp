#include "models/display/pixel_format.hpp"

#include <stdexcept>

namespace maquette::models {

namespace {

constexpr int k_component_bits = 8;
constexpr int k_word_bits = 16;
constexpr std::uint32_t k_full_component = 0xFF;
constexpr std::uint32_t k_full_word = 0xFFFF;

std::uint32_t low_bits(int bits) { return (1U << static_cast<unsigned>(bits)) - 1; }

void check(const FrameMemoryParameters& parameters) {
  for (const int bits : {parameters.red_bits, parameters.green_bits, parameters.blue_bits}) {
    if (bits < 1 || bits > k_component_bits) {
      throw std::invalid_argument("a component of the frame memory has 1 to 8 bits");
    }
  }
  if (parameters.depth_bits < 0 || parameters.depth_bits > k_word_bits) {
    throw std::invalid_argument("the depth of the frame memory has 0 to 16 bits");
  }
  if (parameters.depth_bits > 0 &&
      parameters.red_bits + parameters.green_bits + parameters.blue_bits > k_word_bits) {
    throw std::invalid_argument("a frame memory with depth planes has at most 16 of colour");
  }
}

// The video converters' full scale is the planes' full code.
std::uint32_t full_scale(std::uint32_t code, int bits) {
  const std::uint32_t highest = low_bits(bits);
  return (code * k_full_component + highest / 2) / highest;
}

}  // namespace

PixelFormat::PixelFormat(const FrameMemoryParameters& parameters) {
  check(parameters);
  has_depth_ = parameters.depth_bits > 0;
  const int red = parameters.red_bits;
  const int green = parameters.green_bits;
  const int blue = parameters.blue_bits;
  if (has_depth_) {
    red_ = {red, k_word_bits + green + blue};
    green_ = {green, k_word_bits + blue};
    blue_ = {blue, k_word_bits};
    kept_ = k_full_word & ~low_bits(k_word_bits - parameters.depth_bits);
  } else {
    red_ = {red, 4 * k_component_bits - red};
    green_ = {green, 3 * k_component_bits - green};
    blue_ = {blue, 2 * k_component_bits - blue};
    shows_codes_ = red + green + blue == 3 * k_component_bits;
  }
  for (const Component& component : {red_, green_, blue_}) {
    kept_ |= low_bits(component.bits) << static_cast<unsigned>(component.shift);
  }
}

std::uint32_t PixelFormat::written(std::uint32_t rgb, std::uint16_t depth) const {
  if (!has_depth_) {
    return rgb << static_cast<unsigned>(k_component_bits);
  }
  const auto placed = [](std::uint32_t value, const Component& component) {
    const std::uint32_t code =
        (value & k_full_component) >> static_cast<unsigned>(k_component_bits - component.bits);
    return code << static_cast<unsigned>(component.shift);
  };
  return placed(rgb >> 16U, red_) | placed(rgb >> 8U, green_) | placed(rgb, blue_) | depth;
}

std::uint32_t PixelFormat::colour(std::uint32_t bytes) const {
  if (shows_codes_) {
    return bytes >> static_cast<unsigned>(k_component_bits);
  }
  const auto shown = [bytes](const Component& component) {
    return full_scale(bytes >> static_cast<unsigned>(component.shift) & low_bits(component.bits),
                      component.bits);
  };
  return shown(red_) << 16U | shown(green_) << 8U | shown(blue_);
}

std::uint16_t PixelFormat::depth(std::uint32_t bytes) const {
  return has_depth_ ? static_cast<std::uint16_t>(bytes & k_full_word) : std::uint16_t{0};
}

}  // namespace maquette::models
