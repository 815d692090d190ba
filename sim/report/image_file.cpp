#include "sim/report/image_file.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstdint>
#include <stdexcept>
#include <vector>

#include "sim/description/description_error.hpp"

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

// Run lengths of differences to the row above: for 768x575 pixels 9 ms and within 2 % of the
// smallest file; the library's defaults take 50 ms and more.
OIIO::ImageSpec png_specification(int width, int height) {
  constexpr int png_filter_up = 0x20;
  OIIO::ImageSpec specification(width, height, k_channels, OIIO::TypeDesc::UINT8);
  specification.attribute("png:compressionLevel", 1);
  specification.attribute("png:filter", png_filter_up);
  specification.attribute("compression", "rle");
  return specification;
}

// The library may give several lines, of which the first says what is wrong.
template <typename File>
std::string first_error(File& file) {
  const std::string errors = file.geterror();
  return errors.substr(0, errors.find('\n'));
}

}  // namespace

std::string encode_png(const models::Picture& picture) {
  if (picture.width <= 0 || picture.height <= 0 ||
      picture.pixels.size() != pixel_count(picture.width, picture.height)) {
    throw std::invalid_argument("a picture needs width * height pixels, and at least one");
  }
  const std::vector<std::uint8_t> channels = to_channels(picture.pixels);
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto output = OIIO::ImageOutput::create("png");
  if (!output) {
    throw std::runtime_error("OpenImageIO cannot write PNG: " + OIIO::geterror());
  }
  output->set_ioproxy(&memory);
  if (!output->open("memory.png", png_specification(picture.width, picture.height)) ||
      !output->write_image(OIIO::TypeDesc::UINT8, channels.data()) || !output->close()) {
    throw std::runtime_error("OpenImageIO cannot write PNG: " + first_error(*output));
  }
  return {bytes.begin(), bytes.end()};
}

models::Picture decode_png(const std::string& bytes, const std::string& name) {
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  const auto input = OIIO::ImageInput::create("png");
  if (!input) {
    throw std::runtime_error("OpenImageIO cannot read PNG: " + OIIO::geterror());
  }
  input->set_ioproxy(&memory);
  OIIO::ImageSpec specification;
  if (!input->open("memory.png", specification)) {
    throw DescriptionError(name + ": is not a PNG file that can be read: " + first_error(*input));
  }
  if (specification.nchannels != k_channels || specification.format != OIIO::TypeDesc::UINT8) {
    throw DescriptionError(name + ": has not the three 8-bit channels of a frame");
  }
  std::vector<std::uint8_t> channels(pixel_count(specification.width, specification.height) *
                                     k_channels);
  if (!input->read_image(0, 0, 0, k_channels, OIIO::TypeDesc::UINT8, channels.data())) {
    throw DescriptionError(name + ": is damaged: " + first_error(*input));
  }
  return {specification.width, specification.height, to_pixels(channels)};
}

}  // namespace maquette::sim
