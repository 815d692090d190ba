#include "sim/stability/stiff_machines.hpp"

#include <algorithm>
#include <cmath>

#include "models/bus/wide.hpp"

namespace maquette::sim {

namespace {

using models::Duration;

constexpr models::PixelRectangle k_few_pixels{3, 5, 8, 4};
constexpr int k_words_per_pixel = 2;
constexpr Duration k_second = std::chrono::seconds(1);
constexpr Duration k_day = std::chrono::hours(24);

/// So many clocks, rounded down to the picosecond.
Duration clocks(std::int64_t count, double clock_hz) {
  constexpr models::Wide k_ps_millihertz = 1'000'000'000'000'000;
  const auto millihertz = static_cast<std::int64_t>(std::llround(clock_hz * 1e3));
  return Duration{static_cast<std::int64_t>(count * k_ps_millihertz / millihertz)};
}

/// The clocks begun in a time, none in a negative one.
std::int64_t clocks_begun(Duration time, double clock_hz) {
  constexpr models::Wide k_ps_millihertz = 1'000'000'000'000'000;
  const auto millihertz = static_cast<std::int64_t>(std::llround(clock_hz * 1e3));
  const auto ps = static_cast<models::Wide>(std::max(time, Duration::zero()).count());
  return static_cast<std::int64_t>((ps * millihertz + k_ps_millihertz - 1) / k_ps_millihertz);
}

/// An access of a board, by the rule of the VM02 data sheet: whole clocks, the last one begun, and
/// never less than the slave takes.
Duration access_of(const models::MachineParameters& parameters) {
  const models::Kvm02Parameters& board = parameters.board;
  const Duration slave = parameters.frame_memory.access_time;
  const std::int64_t by_slack =
      board.access_clocks + clocks_begun(slave - board.access_slack, board.clock_hz);
  return clocks(std::max(by_slack, clocks_begun(slave, board.clock_hz)), board.clock_hz);
}

/// Of a board alone: what it computes, and its words one after the other.
Duration time_alone(const TrialMachine& trial) {
  const models::MachineParameters& parameters = trial.machine.parameters;
  const Duration word =
      clocks(parameters.bus.arbitration_clocks, parameters.bus.clock_hz) + access_of(parameters);
  const Duration gap = clocks(parameters.board.word_gap_clocks, parameters.board.clock_hz);
  Duration sum{};
  for (std::int64_t index = 0; index < trial.zone.pixels(); ++index) {
    sum += clocks(trial.work(index), parameters.board.clock_hz) + k_words_per_pixel * word + gap;
  }
  return sum;
}

MachineCase alone(const char* subject, double board_hz, double bus_hz, Duration access_time) {
  MachineCase one{subject, trial_machine(1, k_few_pixels), {}, {}, models::k_nobody, ""};
  models::MachineParameters& parameters = one.trial.machine.parameters;
  parameters.board.clock_hz = board_hz;
  parameters.host.clock_hz = board_hz;
  parameters.bus.clock_hz = bus_hz;
  parameters.bus.timeout = Duration::zero();
  parameters.frame_memory.access_time = access_time;
  parameters.shared_memory.access_time = access_time;
  parameters.board.word_gap_clocks = 7;
  one.trial.work = [](std::int64_t index) { return static_cast<std::uint32_t>(index * 37 % 1001); };
  return one;
}

void append_stiff(std::vector<MachineCase>& cases) {
  for (const double board_hz : {1e3, 1e6, 1e9}) {
    for (const double bus_hz : {1e3, 1e9}) {
      for (const Duration access_time : {Duration{}, Duration{1000}, k_second}) {
        for (const models::Clocks arbitration : {0, 1, 1000}) {
          cases.push_back(alone("time constants from 1 ns to 1 s", board_hz, bus_hz, access_time));
          TrialMachine& trial = cases.back().trial;
          trial.machine.parameters.bus.arbitration_clocks = arbitration;
          cases.back().frame_time = time_alone(trial);
        }
      }
    }
  }
}

void append_odd(std::vector<MachineCase>& cases) {
  for (const double board_hz : {7.999999e6, 14.318181e6, 999'999'999.999, 1000.001}) {
    for (const double bus_hz : {12.345678e6, 1000.007}) {
      cases.push_back(alone("clocks of no whole picoseconds", board_hz, bus_hz, Duration{333'333}));
      cases.back().frame_time = time_alone(cases.back().trial);
    }
  }
}

/// A board whose pixels take so long together, at 1 kHz.
MachineCase days(const char* subject, Duration all) {
  MachineCase one = alone(subject, 1e3, 8e6, Duration{250'000});
  const auto each =
      static_cast<std::uint32_t>(all / std::chrono::milliseconds(1) / one.trial.zone.pixels());
  one.trial.work = [each](std::int64_t) { return each; };
  return one;
}

void append_days(std::vector<MachineCase>& cases) {
  for (const int count : {1, 10, 99}) {
    cases.push_back(days("frames of days", count * k_day));
    cases.back().frame_time = time_alone(cases.back().trial);
  }
}

}  // namespace

std::vector<MachineCase> stiff_machines() {
  std::vector<MachineCase> cases;
  append_stiff(cases);
  append_odd(cases);
  append_days(cases);
  return cases;
}

std::vector<MachineCase> endless_machines() {
  std::vector<MachineCase> cases;
  for (const int count : {101, 1000}) {
    cases.push_back(days("frames of more than 100 days", count * k_day));
    cases.back().refusal = "board0 is not done within 100 days";
  }
  return cases;
}

}  // namespace maquette::sim
