#pragma once

#include <optional>
#include <vector>

#include "models/display/picture.hpp"
#include "sim/accuracy/ladder_result.hpp"

namespace maquette::sim {

/// The errors of the tiles as a picture of the screen: white where there is none, towards red where
/// a level takes too long, towards blue where too short; the worst tile has the full colour. Tiles
/// that are not timed are light grey, what is outside of the useful zone is dark.
[[nodiscard]] models::Picture tile_map(const TileError& error, int width, int height);

/// The errors of the level whose worst tile is the worst of all, if any level has timed tiles.
[[nodiscard]] std::optional<TileError> mapped_error(const std::vector<LadderResult>& results);

}  // namespace maquette::sim
