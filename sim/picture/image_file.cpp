#include "sim/picture/image_file.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "sim/picture/png_codec.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr int k_channels = 3;
constexpr int k_byte_bits = 8;

std::size_t pixel_count(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

PngImage to_channels(const models::Picture& picture) {
  PngImage image{static_cast<std::uint32_t>(picture.width),
                 static_cast<std::uint32_t>(picture.height),
                 k_channels,
                 k_byte_bits,
                 {}};
  image.bytes.reserve(picture.pixels.size() * k_channels);
  for (const std::uint32_t pixel : picture.pixels) {
    for (const int shift : {16, 8, 0}) {
      image.bytes.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  return image;
}

PngImage to_channels(const models::DepthMap& depths) {
  PngImage image{static_cast<std::uint32_t>(depths.width),
                 static_cast<std::uint32_t>(depths.height),
                 1,
                 2 * k_byte_bits,
                 {}};
  image.bytes.reserve(depths.values.size() * 2);
  for (const std::uint16_t depth : depths.values) {
    image.bytes.push_back(static_cast<std::uint8_t>(depth >> k_byte_bits));
    image.bytes.push_back(static_cast<std::uint8_t>(depth));
  }
  return image;
}

/// So many bytes, the first the highest, as one number each.
template <class Value>
std::vector<Value> to_values(const std::vector<std::uint8_t>& bytes, std::size_t per_value) {
  std::vector<Value> values(bytes.size() / per_value);
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    Value& value = values[i / per_value];
    value = static_cast<Value>(value << k_byte_bits | bytes[i]);
  }
  return values;
}

void check_size(int width, int height, std::size_t pixels) {
  if (width <= 0 || height <= 0 || pixels != pixel_count(width, height)) {
    throw std::invalid_argument("a picture needs width * height pixels, and at least one");
  }
}

/// The image in a file, which must have such channels; `wanted` names them.
PngImage decoded(const std::string& file, const std::string& name, int channels, int bits,
                 const char* wanted) {
  PngImage image;
  try {
    image = decode_image(file);
  } catch (const std::runtime_error& error) {
    throw DescriptionError(name + ": " + error.what());
  }
  if (image.channels != channels || image.bits != bits) {
    throw DescriptionError(name + ": has not " + wanted);
  }
  return image;
}

}  // namespace

std::string encode_png(const models::Picture& picture) {
  check_size(picture.width, picture.height, picture.pixels.size());
  return encode(to_channels(picture));
}

std::string encode_depths(const models::DepthMap& depths) {
  check_size(depths.width, depths.height, depths.values.size());
  return encode(to_channels(depths));
}

models::Picture decode_png(const std::string& bytes, const std::string& name) {
  const PngImage image =
      decoded(bytes, name, k_channels, k_byte_bits, "the three 8-bit channels of a frame");
  return {static_cast<int>(image.width), static_cast<int>(image.height),
          to_values<std::uint32_t>(image.bytes, k_channels)};
}

models::DepthMap decode_depths(const std::string& bytes, const std::string& name) {
  const PngImage image =
      decoded(bytes, name, 1, 2 * k_byte_bits, "the one 16-bit channel of depths");
  return {static_cast<int>(image.width), static_cast<int>(image.height),
          to_values<std::uint16_t>(image.bytes, 2)};
}

}  // namespace maquette::sim
