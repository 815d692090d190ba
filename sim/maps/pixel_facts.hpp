#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "firmware/arithmetic/extent_use.hpp"
#include "models/board/pixel_meter.hpp"
#include "models/board/pixel_rectangle.hpp"
#include "models/board/pixel_source.hpp"
#include "models/bus/instant.hpp"
#include "sim/report/function_statistics.hpp"

namespace maquette::sim {

/// What is seen through the centre of a pixel.
struct PixelSight {
  bool is_seen = false;           ///< else it is the background
  std::uint32_t primitive = 0;    ///< its place among those of the database
  std::uint32_t surface = 0;      ///< its place among those that primitives have
  float distance = 0;             ///< from the eye, or from its plane in a parallel view
  std::array<float, 3> normal{};  ///< unit length; to the right, upwards, away from the eye
  int tree_depth = 0;             ///< most secondary rays in a row
};

/// What a run knows of each pixel of its useful zone, row by row; empty where nobody asked for it.
struct PixelFacts {
  int width = 0;  ///< of the frame
  int height = 0;
  models::PixelRectangle zone;
  std::vector<std::string> boards;  ///< by their number
  std::vector<std::string> surfaces;
  std::vector<models::PixelTime> times;
  std::vector<models::Instant> written;          ///< from the frame's start; k_never: not written
  std::vector<models::SynthesizedPixel> pixels;  ///< rays and work
  std::vector<FunctionTimes> functions;          ///< of the time in which its board computed
  std::vector<firmware::ExtentCounts> extents;   ///< of all kinds
  std::vector<PixelSight> sights;
  std::vector<models::Duration> counted;  ///< what its counted work would have taken
};

/// Which of these are asked for.
struct WantedFacts {
  bool times = false;
  bool work = false;
  bool functions = false;
  bool extents = false;
  bool sights = false;
  bool counted = false;

  [[nodiscard]] bool any() const {
    return times || work || functions || extents || sights || counted;
  }
};

}  // namespace maquette::sim
