#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "models/board/allotment.hpp"
#include "models/bus/arbitration.hpp"
#include "models/bus/instant.hpp"
#include "sim/machine/machine.hpp"

namespace maquette::sim {

/// A machine and what its boards compute: `work` branches for each pixel of the zone, by its index.
struct TrialMachine {
  Machine machine;
  models::PixelRectangle zone;
  std::function<std::uint32_t(std::int64_t index)> work;
};

/// How a trial ended. Plain data: it comes from another process.
struct TrialOutcome {
  bool has_finished = false;
  std::int64_t lost_pixels = 0;  ///< of the frame: not written as often as they should be
  std::int64_t disorders = 0;    ///< accesses that begin before the one before ends, and sums amiss
  models::Duration frame_time{};
  models::Duration longest_wait{};
  int longest_waiting = models::k_nobody;  ///< the board that had it
  char message[256] = "";                  ///< why it was refused, or how its process ended
};

/// A machine of some boards on the lowest level, whose arithmetic is free but for a branch, which
/// is one clock; without refresh, video conflicts and gaps between words. Frame: 64 x 48.
[[nodiscard]] TrialMachine trial_machine(int boards, const models::PixelRectangle& zone);

/// Runs each in a process of its own, which ends when it takes `limit_s` of processor time. The
/// same checks as a description's come before: TrialOutcome::message has what they say. Throws as
/// run_forked.
[[nodiscard]] std::vector<TrialOutcome> run_trials(const std::vector<TrialMachine>& trials,
                                                   int limit_s);

}  // namespace maquette::sim
