#pragma once

#include <cstdint>

namespace maquette::models {

/// A rectangle of pixels of the screen, the useful zone.
struct PixelRectangle {
  int column0 = 0;
  int row0 = 0;
  int width = 0;
  int height = 0;

  [[nodiscard]] std::int64_t pixels() const { return static_cast<std::int64_t>(width) * height; }
};

struct PixelPosition {
  int column;
  int row;
};

}  // namespace maquette::models
