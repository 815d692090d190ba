#include "sim/trace/svg_trace.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "sim/report/seconds.hpp"
#include "sim/trace/board_states.hpp"
#include "sim/trace/svg_chart.hpp"

namespace maquette::sim {

namespace {

using models::Instant;

constexpr double k_top = 52;
constexpr double k_axis_top = 620;
constexpr double k_gap = 0.2;  // between tracks, of their height
constexpr double k_tallest = 90;
constexpr double k_tallest_of_bus = 45;
constexpr double k_share_of_buses = 0.3;  // of the height, at most

std::string_view kind_of(BoardState state) {
  switch (state) {
    case BoardState::compute:
      return "compute";
    case BoardState::wait_grant:
      return "wait";
    case BoardState::transfer:
      return "transfer";
    case BoardState::idle:
      break;
  }
  return "idle";
}

std::vector<ChartStay> stays_of(const BusRecord& record, std::size_t board) {
  std::vector<ChartStay> stays;
  for (const StateInterval& interval : board_states(record, board)) {
    stays.push_back({kind_of(interval.state), interval.from, interval.to});
  }
  return stays;
}

/// Arbitration, and who has the bus: boards of even and odd numbers in turn differ.
std::vector<ChartStay> owners_of(const RecordedBus& bus) {
  std::vector<ChartStay> stays;
  for (const RecordedAccess& access : bus.accesses) {
    if (access.is_kept() && !stays.empty()) {
      stays.push_back({"kept", stays.back().to, access.decision()});
    }
    stays.push_back({"arbitration", access.decision(), access.grant});
    stays.push_back({access.board % 2 == 0 ? "even" : "odd", access.grant, access.end()});
  }
  return stays;
}

/// How many requests stand, from each change on.
std::vector<std::pair<Instant, int>> queue_of(const BusRecord& record, const RecordedBus& bus) {
  std::vector<std::pair<Instant, int>> changes{{record.window.from, 0}};
  for (const RecordedAccess& access : bus.accesses) {
    changes.emplace_back(record.window.clip(access.request), 1);
    changes.emplace_back(record.window.clip(access.grant), -1);
  }
  for (const StandingRequest& standing : bus.standing) {
    changes.emplace_back(record.window.clip(standing.request), 1);
  }
  std::sort(changes.begin(), changes.end());
  std::vector<std::pair<Instant, int>> values;
  int length = 0;
  for (const auto& [instant, change] : changes) {
    length += change;
    if (!values.empty() && values.back().first == instant) {
      values.back().second = length;
    } else {
      values.emplace_back(instant, length);
    }
  }
  return values;
}

std::string title_of(const BusRecord& record) {
  return fmt::format("{} bus masters for {}, from {} s of the frame on", record.boards.size(),
                     readable_duration(record.window.to - record.window.from),
                     format_seconds(record.window.from));
}

/// What is handed over between the tracks, where the picture has room for so many arrows.
std::vector<ChartArrow> arrows_of(const BusRecord& record, const std::vector<std::size_t>& boards,
                                  double pitch) {
  constexpr std::size_t k_most_arrows = 400;
  std::vector<ChartArrow> arrows;
  const auto band_of = [&](std::size_t board) {
    const auto track = std::lower_bound(boards.begin(), boards.end(), board) - boards.begin();
    return ChartBand{k_top + pitch * static_cast<double>(track), pitch * (1 - k_gap)};
  };
  const auto is_shown = [&boards](std::size_t board) {
    return std::binary_search(boards.begin(), boards.end(), board);
  };
  for (const RecordedHandover& handover : record.handovers) {
    if (is_shown(handover.from) && is_shown(handover.to)) {
      arrows.push_back(
          {band_of(handover.from), handover.sent, band_of(handover.to), handover.arrived});
    }
  }
  return arrows.size() > k_most_arrows ? std::vector<ChartArrow>() : arrows;
}

}  // namespace

void write_svg_trace(const BusRecord& record, const std::vector<std::size_t>& boards,
                     std::ostream& stream) {
  SvgChart chart(record.window, title_of(record), stream);
  const double height = k_axis_top - k_top;
  const auto bus_tracks = static_cast<double>(2 * record.buses.size());
  const double bus_pitch = std::min(k_tallest_of_bus, k_share_of_buses * height / bus_tracks);
  double pitch =
      std::min(k_tallest, (height - bus_pitch * bus_tracks) / static_cast<double>(boards.size()));
  ChartBand band{k_top, pitch * (1 - k_gap)};
  const auto next = [&band, &pitch] { band.top += pitch; };
  for (const std::size_t board : boards) {
    chart.track(band, record.boards[board].name, stays_of(record, board));
    next();
  }
  chart.arrows(arrows_of(record, boards, pitch));
  pitch = bus_pitch;
  band.height = pitch * (1 - k_gap);
  for (const RecordedBus& bus : record.buses) {
    chart.track(band, bus.name, owners_of(bus));
    for (const RecordedAccess& access : bus.accesses) {
      chart.label(band, fmt::format("{}", access.board), access.grant, access.end());
    }
    next();
    chart.steps(band, "queue", queue_of(record, bus));
    next();
  }
  chart.finish(band.top, {{"compute", "computes"},
                          {"wait", "waits for the bus"},
                          {"transfer", "transfers"},
                          {"idle", "idle"},
                          {"arbitration", "arbitration"},
                          {"even", "bus with an even one"},
                          {"odd", "with an odd one"},
                          {"kept", "kept"}});
}

// A picture has a bounded number of marks, however long its window.
std::int64_t expected_svg_trace_bytes(const BusRecord& record) {
  constexpr std::int64_t k_most_bytes_a_track = 400'000;
  const auto tracks = static_cast<std::int64_t>(record.boards.size() + 2 * record.buses.size());
  return std::min(k_most_bytes_a_track * tracks, expected_bytes(record, 400, 100, 0));
}

}  // namespace maquette::sim
