#pragma once

#include "models/bus/duration.hpp"

namespace maquette::models {

/// The video standard that the video reader follows.
struct VideoParameters {
  int lines_per_frame = 625;
  int frames_per_s = 25;
  bool interlaced = true;
  double pixel_clock_hz = 14.75e6;
  int first_active_line_field_1 = 23;  ///< line numbers from 1
  int first_active_line_field_2 = 336;
  Duration line_blanking{10'500'000};  ///< line start to first active pixel
};

}  // namespace maquette::models
