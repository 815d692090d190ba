#include "sim/picture/image_file.hpp"

#include <cstdint>
#include <stdexcept>
#include <utility>

#include "sim/picture/picture_module.hpp"
#include "sim/picture_module/png_codec.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr int k_channels = 3;

std::size_t pixel_count(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

std::vector<std::uint8_t> to_channels(const std::vector<std::uint32_t>& pixels) {
  std::vector<std::uint8_t> channels;
  channels.reserve(pixels.size() * k_channels);
  for (const std::uint32_t pixel : pixels) {
    for (const int shift : {16, 8, 0}) {
      channels.push_back(static_cast<std::uint8_t>(pixel >> shift));
    }
  }
  return channels;
}

std::vector<std::uint32_t> to_pixels(const std::vector<std::uint8_t>& channels) {
  std::vector<std::uint32_t> pixels(channels.size() / k_channels);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    std::uint32_t& pixel = pixels[i / k_channels];
    pixel = pixel << 8 | channels[i];
  }
  return pixels;
}

const PngCodec& codec() {
  static const PngCodec& loaded =
      *reinterpret_cast<const PngCodec* (*)()>(picture_module_function(k_png_codec_function))();
  return loaded;
}

void check_size(int width, int height, std::size_t pixels) {
  if (width <= 0 || height <= 0 || pixels != pixel_count(width, height)) {
    throw std::invalid_argument("a picture needs width * height pixels, and at least one");
  }
}

void check_done(const std::string& error) {
  if (!error.empty()) {
    throw std::runtime_error(error);
  }
}

}  // namespace

void prepare_png() { codec(); }

std::string encode_png(const models::Picture& picture) {
  check_size(picture.width, picture.height, picture.pixels.size());
  std::string bytes;
  check_done(codec().encode({picture.width, picture.height, to_channels(picture.pixels)}, bytes));
  return bytes;
}

std::string encode_depths(const models::DepthMap& depths) {
  check_size(depths.width, depths.height, depths.values.size());
  std::string bytes;
  check_done(codec().encode_grey({depths.width, depths.height, depths.values}, bytes));
  return bytes;
}

models::Picture decode_png(const std::string& bytes, const std::string& name) {
  PngImage image;
  const std::string error = codec().decode(bytes, image);
  if (!error.empty()) {
    throw DescriptionError(name + ": " + error);
  }
  return {image.width, image.height, to_pixels(image.channels)};
}

models::DepthMap decode_depths(const std::string& bytes, const std::string& name) {
  GreyImage image;
  const std::string error = codec().decode_grey(bytes, image);
  if (!error.empty()) {
    throw DescriptionError(name + ": " + error);
  }
  return {image.width, image.height, std::move(image.values)};
}

}  // namespace maquette::sim
