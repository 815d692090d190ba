#include "sim/report/seconds.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace maquette::sim {
namespace {

constexpr int k_decimals = 12;
constexpr std::uint64_t k_ticks_per_second = 1'000'000'000'000;
constexpr std::uint64_t k_largest = std::numeric_limits<std::int64_t>::max();

std::optional<std::uint64_t> parse_digits(std::string_view text) {
  std::uint64_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  if (result.ec != std::errc() || result.ptr != text.data() + text.size()) {
    return std::nullopt;
  }
  return value;
}

}  // namespace

std::string format_seconds(models::Duration duration) {
  const std::int64_t ticks = duration.count();
  // Unsigned negation is defined for the most negative count too.
  const std::uint64_t magnitude =
      ticks < 0 ? 0 - static_cast<std::uint64_t>(ticks) : static_cast<std::uint64_t>(ticks);
  std::string text = fmt::format("{}{}.{:012}", ticks < 0 ? "-" : "",
                                 magnitude / k_ticks_per_second, magnitude % k_ticks_per_second);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text;
}

std::optional<models::Duration> parse_seconds(std::string_view text) {
  const bool negative = !text.empty() && text.front() == '-';
  if (negative) {
    text.remove_prefix(1);
  }
  const auto point = text.find('.');
  std::string decimals(point == std::string_view::npos ? "0" : text.substr(point + 1));
  if (decimals.empty() || decimals.size() > k_decimals) {
    return std::nullopt;
  }
  decimals.resize(k_decimals, '0');
  const auto whole = parse_digits(text.substr(0, point));
  const auto fraction = parse_digits(decimals);
  if (!whole || !fraction || *whole > (k_largest - *fraction) / k_ticks_per_second) {
    return std::nullopt;
  }
  const auto ticks = static_cast<std::int64_t>(*whole * k_ticks_per_second + *fraction);
  return models::Duration(negative ? -ticks : ticks);
}

std::string readable_duration(models::Duration duration) {
  const double seconds = in_seconds(duration);
  // In tenths, so that 59.96 s reads "1 min 00.0 s" and never "0 min 60.0 s".
  const double tenths = std::round(seconds * 10);
  if (tenths >= 600) {
    const double minutes = std::floor(tenths / 600);
    return fmt::format("{:.0f} min {:04.1f} s", minutes, (tenths - minutes * 600) / 10);
  }
  struct Unit {
    double size;
    const char* name;
  };
  constexpr std::array<Unit, 4> units{{{1, "s"}, {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}}};
  for (const auto& unit : units) {
    if (std::abs(seconds) >= unit.size * 0.9995) {
      return fmt::format("{:.3g} {}", seconds / unit.size, unit.name);
    }
  }
  return fmt::format("{} {}", duration.count(), duration.count() == 0 ? "s" : "ps");
}

}  // namespace maquette::sim
