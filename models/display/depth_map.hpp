#pragma once

#include <cstdint>
#include <vector>

namespace maquette::models {

/// The depths of a picture in row-major order from the top left; 0 is nearest.
struct DepthMap {
  int width = 0;
  int height = 0;
  std::vector<std::uint16_t> values;
};

}  // namespace maquette::models
