#include "sim/report/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <vector>

#include "sim/report/seconds.hpp"

namespace maquette::sim {
namespace {

constexpr std::size_t k_listed_operations = 8;

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

std::string frame_lines(const Statistics& statistics, const std::string& paper_time) {
  const auto& frame = statistics.frame;
  const auto& zone = statistics.useful_zone;
  std::string ending;
  if (statistics.partial) {
    ending = fmt::format("  PARTIAL: {}", statistics.end_reason);
  } else if (!paper_time.empty()) {
    ending = fmt::format("  (the paper: {})", paper_time);
  }
  return fmt::format(
      "frame time      {}{}\n"
      "  loading       {}, before the frame\n"
      "  preprocessing {}\n"
      "  synthesis     {}\n"
      "picture         {} x {}; {} of {} pixels synthesised, useful zone {} x {} at ({}, {})\n",
      readable_duration(frame.time), ending, readable_duration(frame.load),
      readable_duration(frame.preprocess), readable_duration(frame.synthesis), frame.width,
      frame.height, frame.pixels_synthesised, frame.pixels_total, zone.width, zone.height,
      zone.column, zone.row);
}

std::string board_lines(const Statistics& statistics) {
  std::string text =
      fmt::format("\n{:<12}{:>10}{:>12}{:>12}{:>12}{:>12}{:>10}\n", "board", "pixels", "compute s",
                  "wait s", "transfer s", "idle s", "computes");
  const double frame_time = in_seconds(statistics.frame.time);
  for (const auto& board : statistics.boards) {
    text += fmt::format("{:<12}{:>10}{:>12.4f}{:>12.4f}{:>12.4f}{:>12.4f}{:>9.2f}%\n", board.name,
                        board.pixels, in_seconds(board.compute), in_seconds(board.wait_grant),
                        in_seconds(board.transfer), in_seconds(board.idle),
                        100 * ratio(in_seconds(board.compute), frame_time));
  }
  text += fmt::format("  the longest at work is {:.2f} % above the mean\n",
                      100 * statistics.frame.imbalance);
  for (const auto& board : statistics.boards) {
    if (board.claims > 0) {
      text +=
          fmt::format("  {:<14}claimed {} units in {}; {} tries found the lock taken\n", board.name,
                      board.claims - 1, readable_duration(board.claim), board.claim_failed_tries);
    }
  }
  return text;
}

/// What function units and the boards' waits for them come to; nothing where there are none.
std::string unit_lines(const std::optional<UnitsStatistics>& statistics) {
  if (!statistics) {
    return "";
  }
  constexpr double k_percent = 100;
  std::string text = fmt::format("\n{:<18}{:>10}{:>12}{:>12}{:>12}{:>12}{:>10}\n", "unit",
                                 "errands", "serves s", "wait s", "transfer s", "idle s", "busy");
  for (const FunctionUnitStatistics& unit : statistics->units) {
    text += fmt::format("{:<18}{:>10}{:>12.4f}{:>12.4f}{:>12.4f}{:>12.4f}{:>9.2f}%\n", unit.name,
                        unit.errands, in_seconds(unit.serve),
                        in_seconds(unit.wait_grant + unit.wait_place), in_seconds(unit.transfer),
                        in_seconds(unit.idle), k_percent * unit.utilisation);
  }
  for (const UnitKindStatistics& kind : statistics->kinds) {
    text += fmt::format("  {:<16}a place after {} on the mean, {} at most; then {} in the queue\n",
                        kind.kind, readable_duration(kind.place_mean),
                        readable_duration(kind.place_max), readable_duration(kind.queued_mean));
  }
  for (const BoardWaits& board : statistics->boards) {
    text += fmt::format("  {:<16}waited {} for units\n", board.name, readable_duration(board.wait));
  }
  return text + fmt::format("bottleneck      {}, {:.1f} % busy; boards {:.1f} %\n",
                            statistics->bottleneck, k_percent * statistics->bottleneck_utilisation,
                            k_percent * statistics->board_utilisation);
}

/// The options that trace a wait, with as much before and after it, in whole microseconds.
std::string window_around(const LongestWait& wait) {
  constexpr models::Duration k_microsecond{1'000'000};
  const std::int64_t around = 1 + wait.time / k_microsecond;
  const std::int64_t from = wait.requested_at / k_microsecond - around;
  const std::int64_t to = (wait.requested_at + wait.time) / k_microsecond + 1 + around;
  return fmt::format("--trace bus.json --trace-window \"{} us..{} us\"",
                     std::max<std::int64_t>(from, 0), to);
}

/// What the bus does with its time; of several buses, which these are of.
std::string share_line(const BusStatistics& bus) {
  std::vector<std::string> shares;
  for_each_field<BusShares>([&](const auto& field) {
    const double share = bus.shares.*field.member;
    if (share > 0) {
      shares.push_back(fmt::format("{} {:.3f} %", field.name, 100 * share));
    }
  });
  return fmt::format("  time            {}{}\n", fmt::join(shares, ", "),
                     bus.buses == 1 ? "" : fmt::format(", of {} buses", bus.buses));
}

std::string bus_lines(const BusStatistics& bus) {
  std::string text = fmt::format(
      "\nbus             {} transfers, {:.3f} % occupied; wait for grant: mean {}, longest {}\n",
      bus.transfers, 100 * bus.occupied, readable_duration(bus.wait_mean),
      readable_duration(bus.wait_max));
  text += share_line(bus);
  if (bus.database_words > 0) {
    text += fmt::format("  {} of them read the shared database\n", bus.database_words);
  }
  for (const auto& master : bus.masters) {
    text += fmt::format("  {:<14}waited {} in {} transfers, 99 % at most {}, longest {}\n",
                        master.name, readable_duration(master.wait), master.transfers,
                        readable_duration(master.wait_quantiles.nine_of_100),
                        readable_duration(master.wait_max));
  }
  if (bus.longest_wait.time.count() > 0) {
    text += fmt::format("  longest wait    {} after {}, behind {}; to look at it: {}\n",
                        bus.longest_wait.master, readable_duration(bus.longest_wait.requested_at),
                        bus.longest_wait.behind, window_around(bus.longest_wait));
  }
  text += fmt::format("  queue           mean {:.3g} requests, at most {}; fairness {:.4f}\n",
                      bus.queue.mean, bus.queue.longest, bus.fairness);
  return text;
}

std::string ray_lines(const Statistics& statistics) {
  const auto& rays = statistics.rays;
  const auto pixels = static_cast<double>(statistics.frame.pixels_synthesised);
  std::string text = fmt::format("\n{:<12}{:>14}{:>12}\n", "rays", "number", "per pixel");
  const auto line = [&text, pixels](const char* kind, std::int64_t count) {
    text += fmt::format("{:<12}{:>14}{:>12.3f}\n", kind, count,
                        ratio(static_cast<double>(count), pixels));
  };
  line("primary", rays.primary);
  line("reflected", rays.reflected);
  line("refracted", rays.refracted);
  line("shadow", rays.shadow);
  line("all", rays.total);
  return text;
}

/// Clocks of all that was done of each class.
OperationClocks clocks_of(const Statistics& statistics) {
  OperationClocks clocks{};
  for (std::size_t i = 0; i < clocks.size(); ++i) {
    clocks[i] = static_cast<double>(statistics.work[i]) * statistics.costs.clocks[i];
  }
  return clocks;
}

std::string work_lines(const OperationCounts& work, const OperationClocks& clocks) {
  std::vector<std::size_t> order(work.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&clocks](std::size_t first, std::size_t second) {
    return clocks[first] > clocks[second];
  });
  order.resize(std::min(order.size(), k_listed_operations));

  const double all_clocks = std::accumulate(clocks.begin(), clocks.end(), 0.0);
  double listed_clocks = 0;
  std::string text = fmt::format("\n{:<18}{:>14}{:>20}\n", "work", "number", "of counted clocks");
  for (const auto operation : order) {
    listed_clocks += clocks[operation];
    text += fmt::format("{:<18}{:>14}{:>19.2f}%\n", firmware::k_operation_names[operation],
                        work[operation], 100 * ratio(clocks[operation], all_clocks));
  }
  text += fmt::format("{:<18}{:>14}{:>19.2f}%\n", "others", "",
                      100 * ratio(all_clocks - listed_clocks, all_clocks));
  return text;
}

/// Roots by the steps that they took; nothing where there are none.
std::string root_lines(const RootStatistics& statistics) {
  if (!statistics.intersections) {
    return "";
  }
  const IntersectionRoots& roots = *statistics.intersections;
  constexpr double k_percent = 100;
  return fmt::format(
      "\nroots           {} of intersections, {:.2f} steps each: 1 or 2 for {:.1f} %, 3 to 5 for "
      "{:.1f} %, more for {:.2f} %\n",
      roots.found, roots.steps_per_root, k_percent * roots.up_to_two,
      k_percent * roots.three_to_five, k_percent * roots.more);
}

/// Functions by the time they took, then kinds of rays; nothing where it is not known.
std::string function_lines(const FunctionStatistics& functions) {
  if (functions.time == models::Duration::zero()) {
    return "";
  }
  std::string text = fmt::format("\n{:<28}{:>12}{:>12}\n", "function", "time s", "of work");
  const auto line = [&](const std::string& name, models::Duration time) {
    if (time > models::Duration::zero()) {
      text += fmt::format("{:<28}{:>12.4f}{:>11.2f}%\n", name, in_seconds(time),
                          100 * ratio(in_seconds(time), in_seconds(functions.time)));
    }
  };
  const auto& times = functions.by_function.values;
  std::vector<int> order(times.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&times](int first, int second) {
    return times[static_cast<std::size_t>(first)] > times[static_cast<std::size_t>(second)];
  });
  for (const int function : order) {
    line(function_name(function), times[static_cast<std::size_t>(function)]);
  }
  for_each_field<RayTimes>([&](const auto& ray) {
    line(std::string{"in "} + ray.name + (ray.member == &RayTimes::preprocessing ? "" : " rays"),
         functions.by_ray.*ray.member);
  });
  return text;
}

/// How the host's time stands to the machine's.
std::string speed_of(double machine_s, double host_s) {
  if (!(machine_s > 0)) {
    return "in which no time of the machine passed";
  }
  const bool is_faster = machine_s >= host_s;
  const double times = is_faster ? ratio(machine_s, host_s) : ratio(host_s, machine_s);
  return fmt::format("{:.{}f} times {} than the machine", times, times < 10 ? 1 : 0,
                     is_faster ? "faster" : "slower");
}

}  // namespace

std::string summarise(const Statistics& statistics, const std::string& times_from,
                      const std::string& paper_time, double host_time_s) {
  return frame_lines(statistics, paper_time) +
         fmt::format("times           from {}\n", times_from) + board_lines(statistics) +
         unit_lines(statistics.units) + bus_lines(statistics.bus) + ray_lines(statistics) +
         root_lines(statistics.roots) + work_lines(statistics.work, clocks_of(statistics)) +
         function_lines(statistics.functions) +
         fmt::format("\nhost            {:.2f} s, {}\n", host_time_s,
                     speed_of(in_seconds(statistics.frame.time), host_time_s));
}

}  // namespace maquette::sim
