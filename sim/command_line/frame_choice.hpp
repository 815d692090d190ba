#pragma once

#include <functional>
#include <string>
#include <vector>

#include "sim/command_line/run_options.hpp"
#include "sim/scene/description_loader.hpp"

namespace maquette::sim {

/// Simulates the frames of a sequence, and writes their results. `host_time_s` tells the time since
/// the program's start. Returns the exit code. Throws DescriptionError, also for options that are
/// of one frame.
int run_frames(const RunOptions& options, const std::vector<std::string>& command,
               const Description& description, const std::function<double()>& host_time_s);

/// Makes the frame of a sequence that the options name the scene, and returns the one before it,
/// which the boards hold; null where there is none, or no frame is named. Throws DescriptionError.
const Scene* take_frame(const RunOptions& options, Description& description);

}  // namespace maquette::sim
