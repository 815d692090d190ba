#include "sim/picture_module/exr_codec.hpp"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>

#include "sim/picture_module/first_error.hpp"

namespace maquette::sim {
namespace {

constexpr float k_full_code = 255;

std::size_t pixels_of(const ExrImage& image) {
  return static_cast<std::size_t>(image.data_width) * static_cast<std::size_t>(image.data_height);
}

OIIO::TypeDesc type_of(ExrStorage storage) {
  switch (storage) {
    case ExrStorage::code:
      return OIIO::TypeDesc::HALF;
    case ExrStorage::real:
      return OIIO::TypeDesc::FLOAT;
    case ExrStorage::count:
      break;
  }
  return OIIO::TypeDesc::UINT32;
}

OIIO::ImageSpec specification_of(const ExrImage& image) {
  OIIO::ImageSpec specification(image.data_width, image.data_height,
                                static_cast<int>(image.channels.size()), OIIO::TypeDesc::UINT32);
  specification.x = image.data_column;
  specification.y = image.data_row;
  specification.full_width = image.width;
  specification.full_height = image.height;
  specification.channelnames.clear();
  for (const ExrChannel& channel : image.channels) {
    specification.channelnames.push_back(channel.name);
    specification.channelformats.push_back(type_of(channel.storage));
  }
  specification.attribute("compression", "zip:1");
  specification.attribute("DateTime", "");  // or the library writes the clock
  for (const auto& [name, value] : image.attributes) {
    specification.attribute(name, value);
  }
  return specification;
}

std::uint16_t half_of(std::uint32_t code) {
  return glm::packHalf1x16(static_cast<float>(code) / k_full_code);
}

std::uint32_t code_of(std::uint16_t half) {
  return static_cast<std::uint32_t>(
      std::lround(std::clamp(glm::unpackHalf1x16(half), 0.0F, 1.0F) * k_full_code));
}

// Each function puts the channel's value at one place of a pixel, or takes it from there.
void put(const ExrChannel& channel, std::size_t pixel, char* place) {
  switch (channel.storage) {
    case ExrStorage::code: {
      const std::uint16_t half = half_of(channel.values[pixel]);
      std::memcpy(place, &half, sizeof half);
      break;
    }
    case ExrStorage::count:
    case ExrStorage::real:
      std::memcpy(place, &channel.values[pixel], sizeof channel.values[pixel]);
      break;
  }
}

void take(ExrChannel& channel, std::size_t pixel, const char* place) {
  switch (channel.storage) {
    case ExrStorage::code: {
      std::uint16_t half = 0;
      std::memcpy(&half, place, sizeof half);
      channel.values[pixel] = code_of(half);
      break;
    }
    case ExrStorage::count:
    case ExrStorage::real:
      std::memcpy(&channel.values[pixel], place, sizeof channel.values[pixel]);
      break;
  }
}

// The bytes of all pixels as the file's channels have them, one pixel after the other.
std::vector<char> native_pixels(const ExrImage& image, const OIIO::ImageSpec& specification) {
  const std::size_t pixel_bytes = specification.pixel_bytes(true);
  std::vector<char> bytes(pixels_of(image) * pixel_bytes);
  std::size_t offset = 0;
  for (const ExrChannel& channel : image.channels) {
    for (std::size_t pixel = 0; pixel < channel.values.size(); ++pixel) {
      put(channel, pixel, &bytes[pixel * pixel_bytes + offset]);
    }
    offset += type_of(channel.storage).size();
  }
  return bytes;
}

std::string encode(const ExrImage& image, std::string& bytes) {
  std::vector<unsigned char> file;
  OIIO::Filesystem::IOVecOutput memory(file);
  const auto output = OIIO::ImageOutput::create("exr");
  if (!output) {
    return "OpenImageIO cannot write OpenEXR: " + OIIO::geterror();
  }
  output->set_ioproxy(&memory);
  const OIIO::ImageSpec specification = specification_of(image);
  if (!output->open("memory.exr", specification) ||
      !output->write_image(OIIO::TypeDesc::UNKNOWN, native_pixels(image, specification).data()) ||
      !output->close()) {
    return "OpenImageIO cannot write OpenEXR: " + first_error(*output);
  }
  bytes.assign(file.begin(), file.end());
  return {};
}

// Where a channel is in a pixel of the file; empty with an error when it is not there.
std::string find_channel(const OIIO::ImageSpec& specification, const ExrChannel& channel,
                         std::size_t& offset) {
  offset = 0;
  for (int i = 0; i < specification.nchannels; ++i) {
    if (specification.channelnames[static_cast<std::size_t>(i)] == channel.name) {
      return specification.channelformat(i) == type_of(channel.storage)
                 ? std::string{}
                 : "has a channel " + channel.name + " of another type";
    }
    offset += specification.channelformat(i).size();
  }
  return "has no channel " + channel.name;
}

std::string decode_channels(const OIIO::ImageSpec& specification, const std::vector<char>& pixels,
                            ExrImage& image) {
  const std::size_t pixel_bytes = specification.pixel_bytes(true);
  for (ExrChannel& channel : image.channels) {
    std::size_t offset = 0;
    if (std::string error = find_channel(specification, channel, offset); !error.empty()) {
      return error;
    }
    channel.values.resize(pixels_of(image));
    for (std::size_t pixel = 0; pixel < channel.values.size(); ++pixel) {
      take(channel, pixel, &pixels[pixel * pixel_bytes + offset]);
    }
  }
  return {};
}

// A damaged header must not make the program ask for all the memory of the host.
bool is_plausible(const OIIO::ImageSpec& specification, std::size_t file_bytes) {
  constexpr double k_most_compression = 2000;  // deflate reaches about 1000
  return specification.width > 0 && specification.height > 0 &&
         static_cast<double>(specification.image_bytes(true)) <=
             static_cast<double>(file_bytes) * k_most_compression;
}

std::string decode(const std::string& bytes, ExrImage& image) {
  OIIO::Filesystem::IOMemReader memory(bytes.data(), bytes.size());
  const auto input = OIIO::ImageInput::create("exr");
  if (!input) {
    return "OpenImageIO cannot read OpenEXR: " + OIIO::geterror();
  }
  input->set_ioproxy(&memory);
  OIIO::ImageSpec specification;
  if (!input->open("memory.exr", specification)) {
    return "is not an OpenEXR file that can be read: " + first_error(*input);
  }
  image.width = specification.full_width;
  image.height = specification.full_height;
  image.data_column = specification.x;
  image.data_row = specification.y;
  image.data_width = specification.width;
  image.data_height = specification.height;
  for (auto& [name, value] : image.attributes) {
    value = specification.get_string_attribute(name);
  }
  if (!is_plausible(specification, bytes.size())) {
    return "is damaged: its pixels cannot be in so small a file";
  }
  std::vector<char> pixels(pixels_of(image) * specification.pixel_bytes(true));
  if (!input->read_image(0, 0, 0, specification.nchannels, OIIO::TypeDesc::UNKNOWN,
                         pixels.data())) {
    return "is damaged: " + first_error(*input);
  }
  return decode_channels(specification, pixels, image);
}

}  // namespace
}  // namespace maquette::sim

extern "C" const maquette::sim::ExrCodec* maquette_exr_codec() {
  static const maquette::sim::ExrCodec codec{maquette::sim::encode, maquette::sim::decode};
  return &codec;
}
