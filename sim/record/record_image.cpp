#include "sim/record/record_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "sim/record/leg_channels.hpp"
#include "sim/report/digest.hpp"
#include "sim/report/function_statistics.hpp"
#include "sim/yaml/description_error.hpp"

namespace maquette::sim {
namespace {

constexpr const char* k_scene = "maquetteScene";
constexpr const char* k_firmware = "maquetteFirmware";
constexpr const char* k_zone = "maquetteUsefulZone";  // column, row, width, height
constexpr const char* k_preprocessing = "maquettePreprocessing";
constexpr const char* k_preprocessing_functions = "maquettePreprocessingFunctions";
constexpr const char* k_pixel_functions = "maquettePixelFunctions";
constexpr const char* k_has_depth = "maquetteHasDepth";  // 1 or 0
constexpr std::array<const char*, 3> k_colours = {"R", "G", "B"};
constexpr std::array<unsigned, 3> k_colour_shifts = {16, 8, 0};
constexpr std::uint32_t k_byte = 0xFF;

/// Of a picture: a pixel's column and row have 16 bits.
constexpr int k_most_side = 1 << 16;

/// The kinds of rays in a channel each.
struct RayChannel {
  const char* name;
  std::uint32_t firmware::RayCounts::*count;
};
constexpr std::array<RayChannel, 4> k_rays = {{{"rays.primary", &firmware::RayCounts::primary},
                                               {"rays.reflected", &firmware::RayCounts::reflected},
                                               {"rays.refracted", &firmware::RayCounts::refracted},
                                               {"rays.shadow", &firmware::RayCounts::shadow}}};

/// All channels in the order of the file, empty.
std::vector<ExrChannel> empty_channels() {
  std::vector<ExrChannel> channels;
  channels.reserve(k_colours.size() + 1 + k_rays.size() + std::size(firmware::k_operation_names));
  for (const char* colour : k_colours) {
    channels.push_back({colour, ExrStorage::code, {}});
  }
  channels.push_back({"depth", ExrStorage::count, {}});
  for (const RayChannel& ray : k_rays) {
    channels.push_back({ray.name, ExrStorage::count, {}});
  }
  for (const char* operation : firmware::k_operation_names) {
    channels.push_back({fmt::format("work.{}", operation), ExrStorage::count, {}});
  }
  return channels;
}

template <typename Numbers>
std::string joined(const Numbers& numbers) {
  return fmt::format("{}", fmt::join(std::begin(numbers), std::end(numbers), " "));
}

/// Reads as many whole numbers, separated by spaces, as `numbers` has; false when there are not.
template <typename Numbers>
bool split(std::string_view text, Numbers& numbers) {
  const char* place = text.data();
  const char* const end = place + text.size();
  for (auto& number : numbers) {
    while (place != end && *place == ' ') {
      ++place;
    }
    const auto result = std::from_chars(place, end, number);
    if (result.ec != std::errc()) {
      return false;
    }
    place = result.ptr;
  }
  return place == end;
}

/// The numbers of a work by function; false when there are none.
bool read_functions(const std::string& text, FunctionWork& work) {
  std::vector<std::uint64_t> numbers(
      text.empty() ? 0 : 1 + static_cast<std::size_t>(std::count(text.begin(), text.end(), ' ')));
  return split(text, numbers) && read_numbers(numbers, work);
}

/// Channels of the functions in which any pixel has counted something.
void append_functions(const RecordedFrame& frame, std::vector<ExrChannel>& channels) {
  for (int function = 0; function < k_told_function_count; ++function) {
    ExrChannel channel{"function." + function_name(function), ExrStorage::count, {}};
    for (const FunctionCounts& counts : frame.functions) {
      channel.values.push_back(counts[static_cast<std::size_t>(function)]);
    }
    if (std::any_of(channel.values.begin(), channel.values.end(), [](auto n) { return n != 0; })) {
      channels.push_back(std::move(channel));
    }
  }
}

// A file has at least one pixel: without a useful zone it is a black one of no work.
void set_data_window(const models::PixelRectangle& zone, ExrImage& image) {
  const bool is_empty = zone.pixels() == 0;
  image.data_column = is_empty ? 0 : zone.column0;
  image.data_row = is_empty ? 0 : zone.row0;
  image.data_width = is_empty ? 1 : zone.width;
  image.data_height = is_empty ? 1 : zone.height;
}

void append(const models::SynthesizedPixel& pixel, std::vector<ExrChannel>& channels) {
  auto channel = channels.begin();
  for (const unsigned shift : k_colour_shifts) {
    (channel++)->values.push_back(pixel.rgb >> shift & k_byte);
  }
  (channel++)->values.push_back(pixel.depth);
  for (const RayChannel& ray : k_rays) {
    (channel++)->values.push_back(pixel.rays.*ray.count);
  }
  for (const std::uint32_t count : pixel.work.counts) {
    (channel++)->values.push_back(count);
  }
}

/// False when a count does not fit its place.
bool extract(const std::vector<ExrChannel>& channels, std::size_t index,
             models::SynthesizedPixel& pixel) {
  auto channel = channels.begin();
  pixel.rgb = 0;
  for (const unsigned shift : k_colour_shifts) {
    pixel.rgb |= (channel++)->values[index] << shift;
  }
  const std::uint32_t depth = (channel++)->values[index];
  pixel.depth = static_cast<std::uint16_t>(depth);
  for (const RayChannel& ray : k_rays) {
    pixel.rays.*ray.count = (channel++)->values[index];
  }
  for (std::uint32_t& count : pixel.work.counts) {
    count = (channel++)->values[index];
  }
  return pixel.depth == depth;
}

/// Sides and edges are checked one by one, since sums of them may run over.
bool is_within(const models::PixelRectangle& zone, const ExrImage& image) {
  const auto fits = [](int begin, int length, int end) {
    return begin >= 0 && length >= 0 && length <= end && begin <= end - length;
  };
  return image.width <= k_most_side && image.height <= k_most_side &&
         fits(zone.column0, zone.width, image.width) && fits(zone.row0, zone.height, image.height);
}

/// What is wrong with the header, nothing when all is well.
std::string read_header(const ExrImage& image, RecordedFrame& frame) {
  frame.key = {image.attributes.at(k_scene),
               image.attributes.at(k_firmware),
               {image.width, image.height, image.attributes.at(k_has_depth) == "1"}};
  std::array<int, 4> zone{};
  if (frame.key.scene_sha1.empty() || !split(image.attributes.at(k_zone), zone) ||
      !split(image.attributes.at(k_preprocessing), frame.preprocessing.counts) ||
      !read_functions(image.attributes.at(k_preprocessing_functions),
                      frame.by_function.preprocessing) ||
      !read_functions(image.attributes.at(k_pixel_functions), frame.by_function.pixels)) {
    return "is no record of a frame";
  }
  frame.useful_zone = {zone[0], zone[1], zone[2], zone[3]};
  if (!is_within(frame.useful_zone, image)) {
    return "has a useful zone that is not within its picture";
  }
  ExrImage expected;
  set_data_window(frame.useful_zone, expected);
  if (expected.data_column != image.data_column || expected.data_row != image.data_row ||
      expected.data_width != image.data_width || expected.data_height != image.data_height) {
    return "has pixels elsewhere than in its useful zone";
  }
  return {};
}

std::string read_pixels(const ExrImage& image, RecordedFrame& frame) {
  frame.pixels.resize(static_cast<std::size_t>(frame.useful_zone.pixels()));
  for (std::size_t i = 0; i < frame.pixels.size(); ++i) {
    const auto index = static_cast<int>(i);
    models::SynthesizedPixel& pixel = frame.pixels[i];
    pixel.column =
        static_cast<std::uint16_t>(frame.useful_zone.column0 + index % frame.useful_zone.width);
    pixel.row =
        static_cast<std::uint16_t>(frame.useful_zone.row0 + index / frame.useful_zone.width);
    if (!extract(image.channels, i, pixel)) {
      return "has a count that no pixel can have";
    }
  }
  return {};
}

}  // namespace

std::string record_digest(const ExrImage& image) {
  std::string all = fmt::format("{} {}", image.width, image.height);
  for (const auto& [name, text] : image.attributes) {
    const bool is_left_out = name == k_record_digest || (name == k_leg_words && text.empty());
    all += is_left_out ? "" : fmt::format("\n{} {}", name, text);
  }
  const std::size_t channels = empty_channels().size();
  for (std::size_t i = 0; i < channels; ++i) {
    std::uint64_t sum = 0;
    std::uint64_t sum_of_sums = 0;
    for (const std::uint32_t value : image.channels[i].values) {
      sum += value;
      sum_of_sums += sum;
    }
    all += fmt::format("\n{} {} {}", image.channels[i].name, sum, sum_of_sums);
  }
  return sha1_of(all.data(), all.size());
}

ExrImage blank_record_image() {
  ExrImage image;
  image.channels = empty_channels();
  image.attributes = {{k_scene, {}},           {k_firmware, {}},
                      {k_has_depth, {}},       {k_zone, {}},
                      {k_preprocessing, {}},   {k_preprocessing_functions, {}},
                      {k_pixel_functions, {}}, {k_leg_words, {}},
                      {k_record_digest, {}}};
  return image;
}

ExrImage record_image(const RecordedFrame& frame) {
  ExrImage image;
  image.width = frame.key.format.width;
  image.height = frame.key.format.height;
  set_data_window(frame.useful_zone, image);
  image.channels = empty_channels();
  for (const models::SynthesizedPixel& pixel : frame.pixels) {
    append(pixel, image.channels);
  }
  if (frame.pixels.empty()) {
    append({}, image.channels);
  }
  append_functions(frame, image.channels);
  const models::PixelRectangle& zone = frame.useful_zone;
  image.attributes = {
      {k_scene, frame.key.scene_sha1},
      {k_firmware, frame.key.firmware},
      {k_has_depth, frame.key.format.has_depth ? "1" : "0"},
      {k_zone, joined(std::array{zone.column0, zone.row0, zone.width, zone.height})},
      {k_preprocessing, joined(frame.preprocessing.counts)},
      {k_preprocessing_functions, joined(numbers_of(frame.by_function.preprocessing))},
      {k_pixel_functions, joined(numbers_of(frame.by_function.pixels))}};
  if (frame.legs.pixels() > 0) {
    append_legs(frame.legs, image);
  }
  image.attributes[k_record_digest] = record_digest(image);
  return image;
}

RecordedFrame frame_of(const ExrImage& image, const std::string& name) {
  RecordedFrame frame;
  std::string error = read_header(image, frame);
  if (error.empty() && record_digest(image) != image.attributes.at(k_record_digest)) {
    error = "is damaged: its digest is of another content";
  }
  if (error.empty()) {
    error = read_pixels(image, frame);
  }
  if (error.empty() && has_legs(image)) {
    error = read_legs(image, frame.legs);
    if (error.empty() && !legs_make_pixels(frame)) {
      error = "has legs that are not those of its pixels";
    }
  }
  if (!error.empty()) {
    throw DescriptionError(name + ": " + error);
  }
  return frame;
}

}  // namespace maquette::sim
