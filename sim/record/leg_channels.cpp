#include "sim/record/leg_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <vector>

#include "sim/report/digest.hpp"

namespace maquette::sim {

namespace {

using Words = std::vector<std::uint32_t>;

/// More words a pixel are in no record: with them a damaged header cannot ask for all memory.
constexpr std::size_t k_most_channels = 10000;

std::string attribute_of(const Words& words) {
  return fmt::format("{} {}", words.size(), sha1_of(words.data(), words.size() * sizeof words[0]));
}

/// The number of words in the attribute, 0 where it has none.
std::size_t number_of(const std::string& text) {
  std::size_t number = 0;
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

/// Padded, since a file has its channels in the order of their names.
std::string channel_name(std::size_t channel) { return fmt::format("legs.{:04}", channel); }

std::size_t pixels_of(const ExrImage& image) {
  return static_cast<std::size_t>(image.data_width) * static_cast<std::size_t>(image.data_height);
}

/// Words are in the order of a file's rows: of each row channel after channel.
std::size_t word_of(const ExrImage& image, std::size_t channels, std::size_t channel,
                    std::size_t pixel) {
  const auto width = static_cast<std::size_t>(image.data_width);
  return (pixel / width * channels + channel) * width + pixel % width;
}

/// So many words as the attribute says, or as the channels have.
Words words_of(const ExrImage& image) {
  std::vector<const ExrChannel*> channels;
  for (const ExrChannel& channel : image.channels) {
    if (channel.name == channel_name(channels.size())) {
      channels.push_back(&channel);
    }
  }
  Words words(channels.size() * pixels_of(image));
  for (std::size_t channel = 0; channel < channels.size(); ++channel) {
    for (std::size_t pixel = 0; pixel < pixels_of(image); ++pixel) {
      words[word_of(image, channels.size(), channel, pixel)] = channels[channel]->values[pixel];
    }
  }
  words.resize(std::min(words.size(), number_of(image.attributes.at(k_leg_words))));
  return words;
}

}  // namespace

bool has_legs(const ExrImage& image) {
  const auto found = image.attributes.find(k_leg_words);
  return found != image.attributes.end() && !found->second.empty();
}

void append_legs(const LegTable& legs, ExrImage& image) {
  const Words words = legs.words();
  const std::size_t pixels = pixels_of(image);
  const std::size_t channels = (words.size() + pixels - 1) / pixels;
  for (std::size_t channel = 0; channel < channels; ++channel) {
    ExrChannel& added = image.channels.emplace_back();
    added.name = channel_name(channel);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
      const std::size_t word = word_of(image, channels, channel, pixel);
      added.values.push_back(word < words.size() ? words[word] : 0);
    }
  }
  image.attributes[k_leg_words] = attribute_of(words);
}

std::string expect_legs(ExrImage& image) {
  if (!has_legs(image)) {
    return {};
  }
  const std::size_t words = number_of(image.attributes.at(k_leg_words));
  const std::size_t pixels = pixels_of(image);
  if (words == 0 || words > k_most_channels * pixels) {
    return "is damaged: it says no number of words of legs that it may have";
  }
  for (std::size_t channel = 0; channel * pixels < words; ++channel) {
    image.channels.push_back({channel_name(channel), ExrStorage::count, {}});
  }
  return {};
}

std::string leg_digest(const ExrImage& image) {
  return has_legs(image) ? attribute_of(words_of(image)) : "";
}

std::string read_legs(const ExrImage& image, LegTable& legs) {
  const Words words = words_of(image);
  const std::string& text = image.attributes.at(k_leg_words);
  if (words.size() < number_of(text)) {
    return "has fewer words of legs than it says";
  }
  if (attribute_of(words) != text) {
    return "is damaged: its legs are of another content";
  }
  return legs.read(words);
}

}  // namespace maquette::sim
