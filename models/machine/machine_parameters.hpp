#pragma once

#include <vector>

#include "models/board/allotment_parameters.hpp"
#include "models/board/kvm02_parameters.hpp"
#include "models/board/shared_memory_parameters.hpp"
#include "models/bus/versabus_parameters.hpp"
#include "models/display/frame_memory_parameters.hpp"
#include "models/display/video_parameters.hpp"
#include "models/machine/host_parameters.hpp"
#include "models/unit/unit_parameters.hpp"

namespace maquette::models {

/// A whole machine as the models need it.
struct MachineParameters {
  std::vector<BusMasterPlace> boards;  ///< one per board, in board order
  Kvm02Parameters board;
  VersaBusParameters bus;
  FrameMemoryParameters frame_memory;
  VideoParameters video;
  HostParameters host;
  AllotmentParameters allotment;
  SharedMemoryParameters shared_memory;
  UnitsParameters units;
};

}  // namespace maquette::models
