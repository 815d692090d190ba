#pragma once

#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// What a picture is made of: pixels, each with a colour and, where the display takes it, a depth.
struct PictureFormat {
  int width;
  int height;
  bool has_depth = false;
};

/// The format of the pictures in a machine's frame memory.
inline PictureFormat picture_format_of(const Machine& machine) {
  const models::FrameMemoryParameters& memory = machine.parameters.frame_memory;
  return {memory.width, memory.height, memory.depth_bits > 0};
}

}  // namespace maquette::sim
