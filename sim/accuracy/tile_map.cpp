#include "sim/accuracy/tile_map.hpp"

#include <cmath>
#include <cstdint>

namespace maquette::sim {

namespace {

constexpr std::uint32_t k_outside = 0x404040;
constexpr std::uint32_t k_not_timed = 0xB0B0B0;
constexpr std::uint32_t k_white = 0xFFFFFF;

/// `error` is relative to the worst: -1 to 1.
std::uint32_t colour_of(double error) {
  constexpr std::uint32_t k_full = 0xFF;
  const auto fading = static_cast<std::uint32_t>(std::lround(k_full * std::abs(error)));
  return error > 0 ? k_white - fading * 0x000101 : k_white - fading * 0x010100;
}

void fill(const models::PixelRectangle& pixels, std::uint32_t rgb, models::Picture& picture) {
  for (int row = pixels.row0; row < pixels.row0 + pixels.height; ++row) {
    for (int column = pixels.column0; column < pixels.column0 + pixels.width; ++column) {
      picture.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width) +
                     static_cast<std::size_t>(column)] = rgb;
    }
  }
}

}  // namespace

models::Picture tile_map(const TileError& error, int width, int height) {
  models::Picture map{
      width, height,
      std::vector<std::uint32_t>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                                 k_outside)};
  const double worst = error.worst > 0 ? error.worst : 1;
  for (std::size_t tile = 0; tile < error.relative.size(); ++tile) {
    const std::optional<double>& relative = error.relative[tile];
    fill(error.grid.rectangle(tile), relative ? colour_of(*relative / worst) : k_not_timed, map);
  }
  return map;
}

std::optional<TileError> mapped_error(const std::vector<LadderResult>& results) {
  std::optional<TileError> worst;
  for (const LadderResult& result : results) {
    for (const LevelResult& level : result.levels) {
      const std::optional<TileError>& error = level.error.tiles;
      if (error && (!worst || error->worst > worst->worst)) {
        worst = error;
      }
    }
  }
  return worst;
}

}  // namespace maquette::sim
