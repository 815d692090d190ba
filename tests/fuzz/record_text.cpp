#include "tests/fuzz/record_text.hpp"

#include <algorithm>
#include <cstring>
#include <random>
#include <sstream>

#include "sim/record/leg_channels.hpp"
#include "sim/record/record_image.hpp"

namespace maquette::fuzz {

namespace {

/// Pixels of a data window; those of a file are bounded by its size.
constexpr int k_most_side = 8;

/// Its header, by which the data window goes unless another follows.
constexpr const char* k_zone = "maquetteUsefulZone";

void append_number(std::string& bytes, std::uint32_t number) {
  char four[sizeof number];
  std::memcpy(four, &number, sizeof number);
  bytes.append(four, sizeof number);
}

std::uint32_t number_at(std::string_view bytes, std::size_t index) {
  std::uint32_t number = 0;
  const std::size_t offset = index * sizeof number;
  if (offset < bytes.size()) {
    std::memcpy(&number, bytes.data() + offset, std::min(sizeof number, bytes.size() - offset));
  }
  return number;
}

/// As decoding fills them: codes are those of a byte.
void read_channels(std::string_view counts, sim::ExrImage& image) {
  constexpr std::uint32_t k_byte = 0xFF;
  const auto pixels =
      static_cast<std::size_t>(image.data_width) * static_cast<std::size_t>(image.data_height);
  std::size_t index = 0;
  for (sim::ExrChannel& channel : image.channels) {
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      const std::uint32_t number = number_at(counts, index++);
      channel.values.push_back(channel.storage == sim::ExrStorage::code ? number & k_byte : number);
    }
  }
}

void read_line(const std::string& line, sim::ExrImage& image) {
  std::istringstream words{line};
  std::string name;
  words >> name;
  if (name == "window") {
    words >> image.width >> image.height >> image.data_column >> image.data_row >>
        image.data_width >> image.data_height;
  }
  if (name == k_zone) {
    std::istringstream numbers{line.substr(name.size())};
    models::PixelRectangle zone;
    if (numbers >> zone.column0 >> zone.row0 >> zone.width >> zone.height) {
      image.data_column = zone.column0;
      image.data_row = zone.row0;
      image.data_width = zone.width;
      image.data_height = zone.height;
    }
  }
  const auto attribute = image.attributes.find(name);
  if (attribute != image.attributes.end()) {
    attribute->second = line.substr(std::min(line.size(), name.size() + 1));
  }
}

}  // namespace

std::string text_of(const sim::ExrImage& image) {
  std::ostringstream text;
  text << "window " << image.width << ' ' << image.height << ' ' << image.data_column << ' '
       << image.data_row << ' ' << image.data_width << ' ' << image.data_height << '\n';
  for (const auto& [name, value] : image.attributes) {
    text << name << ' ' << value << '\n';
  }
  text << '\n';
  std::string bytes = text.str();
  for (const sim::ExrChannel& channel : image.channels) {
    for (const std::uint32_t value : channel.values) {
      append_number(bytes, value);
    }
  }
  return bytes;
}

sim::ExrImage image_of(const std::string& text) {
  sim::ExrImage image = sim::blank_record_image();
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string line = text.substr(begin, end - begin);
    begin = end + 1;
    if (line.empty()) {
      break;
    }
    read_line(line, image);
  }
  image.data_width = std::clamp(image.data_width, 1, k_most_side);
  image.data_height = std::clamp(image.data_height, 1, k_most_side);
  static_cast<void>(sim::expect_legs(image));
  read_channels(std::string_view{text}.substr(std::min(begin, text.size())), image);
  return image;
}

std::vector<sim::RecordedFrame> small_frames() {
  std::mt19937 random{1984};
  std::vector<sim::RecordedFrame> frames;
  for (const models::PixelRectangle& zone :
       {models::PixelRectangle{0, 0, 0, 0}, models::PixelRectangle{3, 2, 1, 1},
        models::PixelRectangle{0, 1, 3, 2}}) {
    sim::RecordedFrame& frame = frames.emplace_back();
    frame.key = {std::string(40, 'a'), std::string(40, 'b'), {8, 4, zone.width == 1}};
    frame.useful_zone = zone;
    for (int i = 0; i < zone.pixels(); ++i) {
      models::SynthesizedPixel& pixel = frame.pixels.emplace_back();
      pixel.column = static_cast<std::uint16_t>(zone.column0 + i % zone.width);
      pixel.row = static_cast<std::uint16_t>(zone.row0 + i / zone.width);
      pixel.rgb = static_cast<std::uint32_t>(random()) & 0xFFFFFFU;
      pixel.rays.primary = 1;
      for (std::uint32_t& count : pixel.work.counts) {
        count = static_cast<std::uint32_t>(random()) >> (random() % 32);
      }
    }
    if (zone.width == 3) {
      for (models::SynthesizedPixel& pixel : frame.pixels) {
        models::PixelLeg leg{};
        leg.stage = models::Stage::photometry;
        leg.work = pixel.work;
        frame.legs.put({leg});
      }
    }
    frame.by_function.pixels.cells[1][2] = random();
    frame.by_function.preprocessing.extents[0].tests = random();
  }
  return frames;
}

}  // namespace maquette::fuzz
