#include "sim/stability/crowded_machines.hpp"

#include <fmt/format.h>

#include "models/bus/arbitration_policies.hpp"
#include "models/bus/bus_levels.hpp"

namespace maquette::sim {

namespace {

using models::Duration;

constexpr models::PixelRectangle k_all{0, 0, 64, 48};
constexpr int k_board_counts[] = {1, 2, 3, 16, 64, 256};  // all divide the pixels
constexpr int k_words_per_pixel = 2;
constexpr Duration k_clock{125'000};  // of boards and bus
constexpr Duration k_day = std::chrono::hours(24);

/// What the bus spends on a board's word.
struct BusTimes {
  Duration arbitration;
  Duration handover;
  Duration access;
};

/// Of boards that all request at once, when they have computed for `computing`, and then again at
/// the end of each access. With fixed priority one board after the other writes all that it has; in
/// turn every access goes to another.
void set_closed_forms(const BusTimes& bus, Duration computing, MachineCase& one) {
  const models::MachineParameters& parameters = one.trial.machine.parameters;
  const auto boards = static_cast<std::int64_t>(parameters.boards.size());
  const std::int64_t words = k_words_per_pixel * one.trial.zone.pixels();
  const Duration all = words * (bus.arbitration + bus.access);
  if (parameters.bus.arbitration == models::k_round_robin) {
    one.frame_time = computing + all + (boards > 1 ? words - 1 : 0) * bus.handover;
  }
  if (parameters.bus.arbitration == models::k_priority) {
    one.frame_time = computing + all + (boards - 1) * bus.handover;
    one.longest_wait = all / boards * (boards - 1) + (boards - 1) * bus.handover + bus.arbitration;
    one.starving = static_cast<int>(boards) - 1;
  }
}

MachineCase crowd(const char* subject, int boards, const models::ArbitrationPolicy& policy) {
  MachineCase one{fmt::format(fmt::runtime(subject), policy.name),
                  trial_machine(boards, k_all),
                  {},
                  {},
                  models::k_nobody,
                  ""};
  one.trial.machine.parameters.bus.arbitration = policy;
  return one;
}

void append_zero_compute(const models::ArbitrationPolicy& policy, std::vector<MachineCase>& cases) {
  for (const int boards : k_board_counts) {
    cases.push_back(crowd("1 to 256 boards on one level, zero compute, {}", boards, policy));
    set_closed_forms({4 * k_clock, k_clock, 7 * k_clock}, {}, cases.back());
  }
}

/// An access of a nanosecond and nothing else.
void append_zero_transfer(const models::ArbitrationPolicy& policy,
                          std::vector<MachineCase>& cases) {
  for (const int boards : k_board_counts) {
    cases.push_back(crowd("zero compute and zero transfer, {}", boards, policy));
    models::MachineParameters& parameters = cases.back().trial.machine.parameters;
    parameters.board.clock_hz = 1e9;
    parameters.board.access_clocks = 1;
    parameters.bus.arbitration_clocks = 0;
    parameters.bus.handover_clocks = 0;
    parameters.frame_memory.access_time = Duration::zero();
    set_closed_forms({{}, {}, Duration{1000}}, {}, cases.back());
  }
}

/// As many pixels as boards, each of 99 days: sums over boards are longer than any duration.
void append_days(const models::ArbitrationPolicy& policy, std::vector<MachineCase>& cases) {
  constexpr std::uint32_t k_thousands_of_seconds = 99 * 86'400 / 1'000;
  cases.push_back(crowd("256 boards, a frame of 99 days, {}", 256, policy));
  MachineCase& one = cases.back();
  one.trial.zone = {0, 0, 64, 4};
  one.trial.machine.parameters.board.clock_hz = 1e6;
  one.trial.machine.parameters.bus.clock_hz = 1e6;
  constexpr auto k_node = static_cast<std::size_t>(firmware::Operation::node);
  one.trial.machine.parameters.board.arithmetic.operations[k_node].clocks = 1e4;
  one.trial.work = [](std::int64_t) { return k_thousands_of_seconds * 100'000; };
  const Duration clock = std::chrono::microseconds(1);
  set_closed_forms({4 * clock, clock, 6 * clock},
                   k_thousands_of_seconds * std::chrono::seconds(1000), one);
}

MachineCase watched(const char* subject, Duration free_time) {
  MachineCase one{subject, trial_machine(4, k_all), {}, {}, models::k_nobody, ""};
  models::FrameMemoryParameters& memory = one.trial.machine.parameters.frame_memory;
  constexpr Duration k_slot{16'000'000'000 / 14'750};  // of 16 pixels at 14.75 MHz
  memory.video_priority = true;
  memory.video_slot_time = k_slot - free_time;
  return one;
}

/// What is exact nowhere else keeps its pixels as well.
void append_levels(std::vector<MachineCase>& cases) {
  for (const models::BusLevel& level : models::k_bus_levels) {
    for (const Duration quantum : {Duration{}, Duration{1000}, Duration{std::chrono::seconds(1)}}) {
      cases.push_back(crowd("64 boards, levels of the bus and quanta", 64, models::k_priority));
      models::MachineParameters& parameters = cases.back().trial.machine.parameters;
      parameters.bus.level = level;
      parameters.bus.quantum = quantum;
      cases.back().trial.work = [](std::int64_t index) {
        return static_cast<std::uint32_t>(index * 37 % 11);
      };
    }
  }
}

}  // namespace

std::vector<MachineCase> crowded_machines() {
  std::vector<MachineCase> cases;
  append_levels(cases);
  for (const models::ArbitrationPolicy& policy : models::k_arbitration_policies) {
    append_zero_compute(policy, cases);
    append_zero_transfer(policy, cases);
    append_days(policy, cases);
  }
  cases.push_back(crowd("64 backplanes, a frame of 99 days", 64, models::k_priority));
  cases.back().trial.machine.parameters.frame_memory.ports = 64;
  cases.back().trial.machine.parameters.board.clock_hz = 1e3;
  cases.back().trial.work = [](std::int64_t) {
    return static_cast<std::uint32_t>(99 * k_day / std::chrono::milliseconds(1) * 64 /
                                      k_all.pixels());
  };
  cases.back().refusal = "longer than 106 days";
  return cases;
}

std::vector<MachineCase> watched_machines() {
  const Duration access_time = models::FrameMemoryParameters{}.access_time;
  std::vector<MachineCase> cases{watched("a video reader that leaves just an access", access_time)};
  for (const Duration free_time : {access_time - models::k_tick, models::k_tick, Duration{}}) {
    cases.push_back(watched("a video reader that takes every slot", free_time));
    cases.back().refusal = "board0 to board3 would starve";
  }
  return cases;
}

std::vector<MachineCase> starving_machines() {
  std::vector<MachineCase> cases;
  cases.push_back(crowd("boards that claim units without a pause, {}", 4, models::k_priority));
  models::MachineParameters& claiming = cases.back().trial.machine.parameters;
  claiming.allotment.assignment = models::Assignment::on_demand;
  claiming.allotment.claim.spin_clocks = 0;
  cases.back().trial.work = [](std::int64_t index) {
    return static_cast<std::uint32_t>(100 + index * 37 % 1001);
  };
  cases.back().refusal = "starves: boards that try to claim a unit";
  return cases;
}

}  // namespace maquette::sim
