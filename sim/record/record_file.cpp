#include "sim/record/record_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <stdexcept>
#include <string_view>

#include "sim/picture/picture_module.hpp"
#include "sim/picture_module/exr_codec.hpp"
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
constexpr const char* k_digest = "maquetteDigest";       // of all that is read
constexpr std::array<const char*, 3> k_colours = {"R", "G", "B"};
constexpr std::array<unsigned, 3> k_colour_shifts = {16, 8, 0};
constexpr std::uint32_t k_byte = 0xFF;

/// The kinds of rays in a channel each.
struct RayChannel {
  const char* name;
  std::uint32_t firmware::RayCounts::*count;
};
constexpr std::array<RayChannel, 4> k_rays = {{{"rays.primary", &firmware::RayCounts::primary},
                                               {"rays.reflected", &firmware::RayCounts::reflected},
                                               {"rays.refracted", &firmware::RayCounts::refracted},
                                               {"rays.shadow", &firmware::RayCounts::shadow}}};

const ExrCodec& codec() {
  static const ExrCodec& loaded =
      *reinterpret_cast<const ExrCodec* (*)()>(picture_module_function(k_exr_codec_function))();
  return loaded;
}

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

/// Over header and counts. The counts of a channel go in as their sum and one that weighs them by
/// their place, since the file's compression has a check of its own for each block of them.
std::string digest_of(const ExrImage& image) {
  std::string all = fmt::format("{} {}", image.width, image.height);
  for (const auto& [name, text] : image.attributes) {
    all += name == k_digest ? "" : fmt::format("\n{} {}", name, text);
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

}  // namespace

std::string encode_record(const RecordedFrame& frame) {
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
  image.attributes[k_digest] = digest_of(image);
  std::string bytes;
  const std::string error = codec().encode(image, bytes);
  if (!error.empty()) {
    throw std::runtime_error(error);
  }
  return bytes;
}

RecordedFrame decode_record(const std::string& bytes, const std::string& name) {
  ExrImage image;
  image.channels = empty_channels();
  image.attributes = {{k_scene, {}},           {k_firmware, {}},
                      {k_has_depth, {}},       {k_zone, {}},
                      {k_preprocessing, {}},   {k_preprocessing_functions, {}},
                      {k_pixel_functions, {}}, {k_digest, {}}};
  RecordedFrame frame;
  std::string error = codec().decode(bytes, image);
  if (error.empty()) {
    error = read_header(image, frame);
  }
  if (error.empty() && digest_of(image) != image.attributes.at(k_digest)) {
    error = "is damaged: its digest is of another content";
  }
  if (error.empty()) {
    error = read_pixels(image, frame);
  }
  if (!error.empty()) {
    throw DescriptionError(name + ": " + error);
  }
  return frame;
}

void check_record(const RecordKey& wanted, const RecordKey& found, const std::string& name) {
  if (found.format.width != wanted.format.width || found.format.height != wanted.format.height) {
    throw DescriptionError(fmt::format(
        "{}: a record of {} x {} pixels; allowed: one of {} x {}, as the frame memory has them",
        name, found.format.width, found.format.height, wanted.format.width, wanted.format.height));
  }
  if (found.format.has_depth != wanted.format.has_depth) {
    throw DescriptionError(fmt::format("{}: a record {} depths; allowed: one {}", name,
                                       found.format.has_depth ? "with" : "without",
                                       wanted.format.has_depth ? "with" : "without"));
  }
  if (found.firmware != wanted.firmware) {
    throw DescriptionError(fmt::format("{}: made by firmware {}; allowed: {}, that of this program",
                                       name, found.firmware, wanted.firmware));
  }
  if (found.scene_sha1 != wanted.scene_sha1) {
    throw DescriptionError(fmt::format(
        "{}: a record of another scene, with database {}; allowed: {}, that of this one", name,
        found.scene_sha1, wanted.scene_sha1));
  }
}

}  // namespace maquette::sim
