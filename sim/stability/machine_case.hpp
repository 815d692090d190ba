#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim/stability/stability_row.hpp"
#include "sim/stability/trial_machine.hpp"

namespace maquette::sim {

/// A machine driven to an extreme, and what is known of its frame beforehand.
struct MachineCase {
  std::string subject;  ///< cases of one subject are counted together
  TrialMachine trial;
  std::optional<models::Duration> frame_time;    ///< a closed form
  std::optional<models::Duration> longest_wait;  ///< of the board that starves
  int starving = models::k_nobody;
  std::string refusal;  ///< not empty: it is to be refused, in words that have these
};

/// How the cases of each subject fare, in the order of the subjects; those of one subject stand
/// together. Throws as run_trials.
[[nodiscard]] std::vector<StabilityRow> machine_case_rows(const std::vector<MachineCase>& cases);

}  // namespace maquette::sim
