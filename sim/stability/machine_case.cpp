#include "sim/stability/machine_case.hpp"

#include <cmath>
#include <string_view>

namespace maquette::sim {

namespace {

/// Of the processor; no case takes a tenth of it.
constexpr int k_limit_s = 60;

struct CaseTally {
  double ended_otherwise = 0;
  double lost_pixels = 0;
  double disorders = 0;
  double ticks_off = 0;
  double starving_unnamed = 0;
  bool has_frames = false;
  bool has_closed_form = false;
  bool has_starving = false;
};

double ticks_between(models::Duration a, models::Duration b) {
  return std::fabs(static_cast<double>(a.count()) - static_cast<double>(b.count()));
}

void add(const MachineCase& one, const TrialOutcome& outcome, CaseTally& tally) {
  const std::string_view message(outcome.message);
  if (!one.refusal.empty()) {
    tally.ended_otherwise += message.find(one.refusal) != std::string_view::npos ? 0 : 1;
    return;
  }
  tally.ended_otherwise += outcome.has_finished && message.empty() ? 0 : 1;
  tally.lost_pixels += static_cast<double>(outcome.lost_pixels);
  tally.disorders += static_cast<double>(outcome.disorders);
  tally.has_frames = true;
  if (one.frame_time) {
    tally.ticks_off += ticks_between(outcome.frame_time, *one.frame_time);
    tally.has_closed_form = true;
  }
  if (one.longest_wait) {
    tally.ticks_off += ticks_between(outcome.longest_wait, *one.longest_wait);
    tally.starving_unnamed += outcome.longest_waiting == one.starving ? 0 : 1;
    tally.has_closed_form = true;
    tally.has_starving = true;
  }
}

void append_rows(const std::string& subject, const CaseTally& tally,
                 std::vector<StabilityRow>& rows) {
  const auto append = [&](bool is_known, const char* counted, double value) {
    if (is_known) {
      rows.push_back({"machines", subject, counted, value, 0});
    }
  };
  append(!tally.has_frames, "machines that are not refused with the reason", tally.ended_otherwise);
  append(tally.has_frames, "machines that hang, crash or are refused", tally.ended_otherwise);
  append(tally.has_frames, "pixels not written exactly once", tally.lost_pixels);
  append(tally.has_frames, "accesses out of order, sums amiss", tally.disorders);
  append(tally.has_closed_form, "ticks off the closed form", tally.ticks_off);
  append(tally.has_starving, "boards that starve and are not named", tally.starving_unnamed);
}

}  // namespace

std::vector<StabilityRow> machine_case_rows(const std::vector<MachineCase>& cases) {
  std::vector<TrialMachine> trials;
  trials.reserve(cases.size());
  for (const MachineCase& one : cases) {
    trials.push_back(one.trial);
  }
  const std::vector<TrialOutcome> outcomes = run_trials(trials, k_limit_s);
  std::vector<StabilityRow> rows;
  CaseTally tally;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    add(cases[i], outcomes[i], tally);
    if (i + 1 == cases.size() || cases[i + 1].subject != cases[i].subject) {
      append_rows(cases[i].subject, tally, rows);
      tally = {};
    }
  }
  return rows;
}

}  // namespace maquette::sim
