#include "sim/report/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

#include "sim/picture/image_file.hpp"
#include "sim/report/flat_yaml.hpp"
#include "sim/report/run_directory.hpp"

namespace maquette::sim {
namespace {

std::optional<double> as_number(const std::string& text) {
  double value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

std::optional<double> relative_difference(const std::string& first, const std::string& second) {
  const auto from = as_number(first);
  const auto to = as_number(second);
  if (!from || !to) {
    return std::nullopt;
  }
  if (*from == 0) {
    return std::copysign(std::numeric_limits<double>::infinity(), *to);
  }
  return (*to - *from) / std::abs(*from);
}

// Long decimals may share their nearest double and still differ: only short ones can be the same
// number in another writing.
bool same_value(const std::string& first, const std::string& second) {
  constexpr auto exact_digits = std::numeric_limits<double>::digits10;
  if (first == second || std::max(first.size(), second.size()) > exact_digits) {
    return first == second;
  }
  const auto from = as_number(first);
  return from && from == as_number(second);
}

models::Picture read_picture(const std::filesystem::path& file) {
  return decode_png(read_file(file), file.string());
}

int channel_of(std::uint32_t pixel, std::size_t channel) {
  return static_cast<int>(pixel >> (16 - 8 * channel) & 0xff);
}

std::string value_lines(const std::string& title, const std::vector<ValueDifference>& differences) {
  if (differences.empty()) {
    return fmt::format("{}: equal\n", title);
  }
  std::string text = fmt::format("{}: {} {}\n", title, differences.size(),
                                 differences.size() == 1 ? "value differs" : "values differ");
  for (const auto& difference : differences) {
    text += fmt::format("  {}: {} -> {}", difference.path, difference.first.value_or("(absent)"),
                        difference.second.value_or("(absent)"));
    if (difference.relative && std::isfinite(*difference.relative)) {
      text += fmt::format(" ({:+.3g} %)", 100 * *difference.relative);
    }
    text += '\n';
  }
  return text;
}

std::string picture_lines(const PictureDifference& picture) {
  const auto [width, height] = picture.first_size;
  if (picture.first_size != picture.second_size) {
    return fmt::format("picture: sizes differ, {} x {} -> {} x {}\n", width, height,
                       picture.second_size[0], picture.second_size[1]);
  }
  if (picture.pixels == 0) {
    return "picture: equal\n";
  }
  std::string text = fmt::format(
      "picture: {} {} ({:.3g} %)\n", picture.pixels,
      picture.pixels == 1 ? "pixel differs" : "pixels differ",
      100 * static_cast<double>(picture.pixels) / (static_cast<double>(width) * height));
  constexpr std::array<const char*, 3> channels{"red", "green", "blue"};
  for (std::size_t i = 0; i < channels.size(); ++i) {
    text += fmt::format("  {}: largest difference {} of 255, mean {:.4g}\n", channels[i],
                        picture.largest[i], picture.mean[i]);
  }
  return text;
}

}  // namespace

std::vector<ValueDifference> compare_values(const FlatValues& first, const FlatValues& second) {
  std::vector<ValueDifference> differences;
  std::map<std::string, std::string> others(second.begin(), second.end());
  for (const auto& [path, value] : first) {
    const auto other = others.extract(path);
    if (other.empty()) {
      differences.push_back({path, value, std::nullopt, std::nullopt});
    } else if (!same_value(value, other.mapped())) {
      differences.push_back(
          {path, value, other.mapped(), relative_difference(value, other.mapped())});
    }
  }
  for (const auto& [path, value] : second) {
    if (others.count(path) != 0) {
      differences.push_back({path, std::nullopt, value, std::nullopt});
    }
  }
  return differences;
}

PictureDifference compare_pictures(const models::Picture& first, const models::Picture& second) {
  PictureDifference difference{
      {first.width, first.height}, {second.width, second.height}, 0, 0, {}, {}};
  if (difference.first_size != difference.second_size) {
    difference.pixels = difference.pixels_off =
        static_cast<std::int64_t>(std::max(first.pixels.size(), second.pixels.size()));
    return difference;
  }
  std::array<std::int64_t, 3> sums{};
  for (std::size_t i = 0; i < first.pixels.size(); ++i) {
    difference.pixels += first.pixels[i] != second.pixels[i] ? 1 : 0;
    int most = 0;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const int change =
          std::abs(channel_of(first.pixels[i], channel) - channel_of(second.pixels[i], channel));
      sums[channel] += change;
      difference.largest[channel] = std::max(difference.largest[channel], change);
      most = std::max(most, change);
    }
    difference.pixels_off += most > 1 ? 1 : 0;
  }
  for (std::size_t channel = 0; channel < 3; ++channel) {
    difference.mean[channel] =
        static_cast<double>(sums[channel]) / static_cast<double>(first.pixels.size());
  }
  return difference;
}

RunComparison compare_runs(const std::filesystem::path& first,
                           const std::filesystem::path& second) {
  const auto configuration = [](const std::filesystem::path& directory) {
    const auto file = directory / "config.yaml";
    return flatten_yaml(read_file(file), file.string());
  };
  const auto statistics = [](const std::filesystem::path& directory) {
    const auto file = directory / "stats.json";
    return flatten_json(read_file(file), file.string());
  };
  return {compare_values(configuration(first), configuration(second)),
          compare_values(statistics(first), statistics(second)),
          compare_pictures(read_picture(first / "frame.png"), read_picture(second / "frame.png"))};
}

std::string comparison_report(const RunComparison& comparison) {
  return value_lines("configuration", comparison.configuration) +
         value_lines("statistics", comparison.statistics) + picture_lines(comparison.picture);
}

}  // namespace maquette::sim
