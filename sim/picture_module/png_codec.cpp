#include "sim/picture_module/png_codec.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include "sim/picture_module/first_error.hpp"

namespace maquette::sim {
namespace {

constexpr int k_channels = 3;

/// The channels of a picture in memory.
struct Channels {
  int width;
  int height;
  int count;
  OIIO::TypeDesc type;
};

// Run lengths of differences to the row above: for 768x575 pixels 9 ms and within 2 % of the
// smallest file; the library's defaults take 50 ms and more.
OIIO::ImageSpec png_specification(const Channels& channels) {
  constexpr int png_filter_up = 0x20;
  OIIO::ImageSpec specification(channels.width, channels.height, channels.count, channels.type);
  specification.attribute("png:compressionLevel", 1);
  specification.attribute("png:filter", png_filter_up);
  specification.attribute("compression", "rle");
  return specification;
}

// OpenImageIO 2.5 writes a chunk of Exif data where there are none, 2.4 writes no chunk. Left out,
// it lets the file be the same from both.
std::string without_exif(const std::vector<unsigned char>& file) {
  constexpr std::size_t signature_bytes = 8;
  constexpr std::size_t frame_bytes = 12;  // of a chunk: length, type, check sum
  std::string bytes(file.begin(), file.begin() + signature_bytes);
  for (std::size_t place = signature_bytes; place + frame_bytes <= file.size();) {
    const auto chunk = file.begin() + static_cast<std::ptrdiff_t>(place);
    std::size_t length = 0;
    for (auto byte = chunk; byte != chunk + 4; ++byte) {
      length = length << 8 | *byte;
    }
    const auto end = chunk + static_cast<std::ptrdiff_t>(frame_bytes + length);
    if (std::string(chunk + 4, chunk + 8) != "eXIf") {
      bytes.append(chunk, end);
    }
    place += frame_bytes + length;
  }
  return bytes;
}

std::string write(const Channels& channels, const void* values, std::string& bytes) {
  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput memory(file);
  const auto output = OIIO::ImageOutput::create("png");
  if (!output) {
    return "OpenImageIO cannot write PNG: " + OIIO::geterror();
  }
  output->set_ioproxy(&memory);
  if (!output->open("memory.png", png_specification(channels)) ||
      !output->write_image(channels.type, values) || !output->close()) {
    return "OpenImageIO cannot write PNG: " + first_error(*output);
  }
  bytes = without_exif(file);
  return {};
}

std::string encode(const PngImage& image, std::string& bytes) {
  return write({image.width, image.height, k_channels, OIIO::TypeDesc::UINT8},
               image.channels.data(), bytes);
}

std::string encode_grey(const GreyImage& image, std::string& bytes) {
  return write({image.width, image.height, 1, OIIO::TypeDesc::UINT16}, image.values.data(), bytes);
}

/// Reads a file into an image, whose values are of the channels' type; `wanted` names them.
template <class Value>
std::string read(const std::string& bytes, const Channels& channels, const char* wanted, int& width,
                 int& height, std::vector<Value>& values) {
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  const auto input = OIIO::ImageInput::create("png");
  if (!input) {
    return "OpenImageIO cannot read PNG: " + OIIO::geterror();
  }
  input->set_ioproxy(&memory);
  OIIO::ImageSpec specification;
  if (!input->open("memory.png", specification)) {
    return "is not a PNG file that can be read: " + first_error(*input);
  }
  if (specification.nchannels != channels.count || specification.format != channels.type) {
    return std::string("has not ") + wanted;
  }
  width = specification.width;
  height = specification.height;
  values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                static_cast<std::size_t>(channels.count));
  if (!input->read_image(0, 0, 0, channels.count, channels.type, values.data())) {
    return "is damaged: " + first_error(*input);
  }
  return {};
}

std::string decode(const std::string& bytes, PngImage& image) {
  return read(bytes, {0, 0, k_channels, OIIO::TypeDesc::UINT8},
              "the three 8-bit channels of a frame", image.width, image.height, image.channels);
}

std::string decode_grey(const std::string& bytes, GreyImage& image) {
  return read(bytes, {0, 0, 1, OIIO::TypeDesc::UINT16}, "the one 16-bit channel of depths",
              image.width, image.height, image.values);
}

}  // namespace
}  // namespace maquette::sim

extern "C" const maquette::sim::PngCodec* maquette_png_codec() {
  static const maquette::sim::PngCodec codec{maquette::sim::encode, maquette::sim::decode,
                                             maquette::sim::encode_grey,
                                             maquette::sim::decode_grey};
  return &codec;
}
