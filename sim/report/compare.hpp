#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "models/display/picture.hpp"
#include "sim/report/flat_json.hpp"

namespace maquette::sim {

/// A value that two runs do not share; a side that lacks the key holds nothing.
struct ValueDifference {
  std::string path;
  std::optional<std::string> first;
  std::optional<std::string> second;
  std::optional<double> relative;  ///< (second - first) / |first|, of numbers; infinite from zero
};

/// How two pictures differ. Values of channels are 0..255, in the order red, green, blue.
struct PictureDifference {
  std::array<int, 2> first_size{};  ///< width and height
  std::array<int, 2> second_size{};
  std::int64_t pixels = 0;       ///< with any difference; all of them when the sizes differ
  std::int64_t pixels_off = 0;   ///< with a channel that differs by more than one level
  std::array<int, 3> largest{};  ///< absolute difference per channel
  std::array<double, 3> mean{};  ///< absolute difference per channel, over all pixels
};

/// What differs between two runs.
struct RunComparison {
  std::vector<ValueDifference> configuration;
  std::vector<ValueDifference> statistics;
  PictureDifference picture;

  [[nodiscard]] bool equal() const {
    return configuration.empty() && statistics.empty() && picture.pixels == 0;
  }
};

/// The values that differ, in the order of `first`, then those that only `second` has. Numbers that
/// are written differently and mean the same (1 and 1.0) do not differ.
std::vector<ValueDifference> compare_values(const FlatValues& first, const FlatValues& second);

PictureDifference compare_pictures(const models::Picture& first, const models::Picture& second);

/// Compares config.yaml, stats.json and frame.png of two run directories. Throws DescriptionError
/// when one of them is missing or damaged.
RunComparison compare_runs(const std::filesystem::path& first, const std::filesystem::path& second);

/// The comparison as a text for the eye.
std::string comparison_report(const RunComparison& comparison);

}  // namespace maquette::sim
