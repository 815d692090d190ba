#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "models/display/depth_map.hpp"
#include "models/display/picture.hpp"
#include "sim/machine/machine.hpp"
#include "sim/maps/pixel_facts.hpp"
#include "sim/record/recorded_frame.hpp"
#include "sim/report/statistics.hpp"
#include "sim/report/summary.hpp"
#include "sim/run/calibration.hpp"
#include "sim/run/frame_film.hpp"
#include "sim/run/scene_warnings.hpp"
#include "sim/scene/scene.hpp"
#include "sim/trace/bus_record.hpp"
#include "sim/trace/line_trace.hpp"

namespace maquette::sim {

/// What to simulate besides scene and machine.
struct SimulationRequest {
  bool picture = true;                            ///< whether the result has it
  int threads = 1;                                ///< of the host, for synthesis
  bool executed = false;                          ///< boards execute their program
  std::vector<int> dumped_boards;                 ///< whose RAM the result has; of executed ones
  const RecordedFrame* record = nullptr;          ///< replayed in place of synthesis, if given
  const Scene* held = nullptr;                    ///< that the boards hold, if they hold one
  const Calibration* calibration = nullptr;       ///< of this scene and machine, if told before
  std::vector<models::Duration> snapshots;        ///< of the frame memory, from the frame's start
  std::vector<models::Duration> shown_snapshots;  ///< of what the video reader shows
  std::optional<TraceWindow> trace;               ///< of the frame, when it is to be recorded
  WantedFacts facts;                              ///< of pixels, for maps
  bool film = false;                              ///< whether the result tells how it was filled
  LineTrace* lines = nullptr;                     ///< shows the backplanes' lines, if given
  std::optional<TraceWindow> video;               ///< in which the video reader is looked at
  Warn warn;                                      ///< is told what may not have been meant
};

/// Called now and then with the simulated time and the share of pixels done; false ends the run.
using Continue = std::function<bool(models::Duration simulated, double fraction)>;

/// What a simulation gives.
struct SimulationResult {
  Statistics statistics;
  std::string times_from;                  ///< what the boards' times are told from
  models::Picture picture;                 ///< the frame memory at the end, when it was asked for
  std::optional<models::DepthMap> depths;  ///< of a display with depths, likewise
  std::vector<models::Picture> snapshots;
  std::vector<models::Picture> shown_snapshots;
  std::vector<std::vector<unsigned char>> rams;  ///< of the dumped boards, at the end
  std::string symbols;                           ///< where things are in them, if there are any
  PixelFacts facts;                              ///< what was asked for, of a finished frame
  std::optional<FrameFilm> film;                 ///< of the frame memory, when one was asked for
  BusRecord trace;                               ///< of the window, when one was asked for
};

/// Throws DescriptionError when the machine's boards can not hold the scene.
void check_fit(const Scene& scene, const Machine& machine);

/// Simulates a frame on a machine: packs the scene, checks it against a board's RAM, elaborates the
/// machine and runs it until all boards are done. SystemC elaborates once per process, so a process
/// may call this once. Throws DescriptionError for a scene that the machine can not hold and for
/// parameters that make no machine; std::logic_error when an invariant of the run is broken.
SimulationResult simulate(const Scene& scene, const Machine& machine,
                          const SimulationRequest& request, const Continue& go_on);

}  // namespace maquette::sim
