#include "sim/accuracy/tile_error.hpp"

#include <algorithm>
#include <cmath>

#include "sim/report/quantile.hpp"

namespace maquette::sim {

TileError tile_error(const TileTimes& tiles, const TileTimes& reference) {
  TileError error;
  error.grid = tiles.grid;
  std::vector<double> sizes;
  for (std::size_t tile = 0; tile < tiles.times.size(); ++tile) {
    error.relative.emplace_back();
    const auto time = static_cast<double>(tiles.times[tile].count());
    const auto reference_time = static_cast<double>(reference.times[tile].count());
    if (time > 0 && reference_time > 0) {
      error.relative.back() = (time - reference_time) / reference_time;
      sizes.push_back(std::abs(*error.relative.back()));
    }
  }
  std::sort(sizes.begin(), sizes.end());
  if (!sizes.empty()) {
    error.median = quantile(sizes, 0.5);
    error.most_of_95 = quantile(sizes, 0.95);
    error.worst = sizes.back();
  }
  return error;
}

}  // namespace maquette::sim
