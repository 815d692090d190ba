#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/sweep/measure.hpp"
#include "sim/yaml/yaml_node.hpp"

namespace maquette::sim {

/// A range of values as a study writes it: `1..64`, `1..64:8`, `8..16 MHz:2`, `0.2..0.5 us of 7`,
/// `log 1..1000 of 12`. Both ends belong to it, the last one if a step reaches it.
struct ValueRange {
  double first = 0;
  double last = 0;
  std::string unit;  ///< of both, and of the step
  bool is_logarithmic = false;
  std::optional<double> step;
  std::optional<int> count;
  YamlPlace place;
};

/// Values that one range may stand for.
inline constexpr int k_most_values = 1'000'000;

/// Reads a range; nothing when the text is none, such as "../scenes/photo4.yaml". Throws
/// DescriptionError at `place` for a range that makes no sense.
[[nodiscard]] std::optional<ValueRange> read_range(const std::string& text, const YamlPlace& place);

/// All values, from the first to the last; values that are whole numbers (`is_whole`) are rounded,
/// and those that become equal are given once. Values between the ends have at most six digits,
/// those of a step twelve. A range of whole numbers needs neither step nor count. Throws
/// DescriptionError when another one has neither, or the values are too many.
[[nodiscard]] std::vector<Measure> values_of(const ValueRange& range, bool is_whole);

/// The value at share `share` (0 <= share < 1) of the range, whole numbers being equally likely.
[[nodiscard]] Measure value_at(const ValueRange& range, bool is_whole, double share);

}  // namespace maquette::sim
