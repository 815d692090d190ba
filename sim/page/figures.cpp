#include "sim/page/figures.hpp"

#include <fmt/format.h>

#include "sim/report/seconds.hpp"

namespace maquette::sim {

double share_of(double part, double whole) { return whole > 0 ? part / whole : 0; }

std::string percent(double share, int decimals) {
  constexpr double k_percent = 100;
  return fmt::format("{:.{}f} %", k_percent * share, decimals);
}

std::string four_decimals(models::Duration time) { return fmt::format("{:.4f}", in_seconds(time)); }

}  // namespace maquette::sim
