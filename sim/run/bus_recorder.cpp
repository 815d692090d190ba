#include "sim/run/bus_recorder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace maquette::sim {

namespace {

using models::BusAccess;
using models::Instant;

RecordedAccess recorded(const BusAccess& access, Instant start) {
  RecordedAccess result;
  result.request = access.request - start;
  result.grant = access.grant - start;
  result.arbitration = access.grant - access.decision;
  result.acknowledge = access.slave_time;
  result.duration = access.end - access.grant;
  result.address = access.address;
  result.data = access.data;
  result.board = static_cast<std::uint16_t>(access.master);
  result.write = access.write ? 1 : 0;
  result.flags =
      static_cast<std::uint8_t>((access.answered ? 0 : RecordedAccess::k_unanswered) |
                                (access.kept ? RecordedAccess::k_kept : 0) |
                                (access.test_and_set ? RecordedAccess::k_test_and_set : 0));
  return result;
}

/// Whether nothing of an access, nor of the gap before it in which the bus was kept, lies in the
/// window before its end.
bool is_beyond(const RecordedAccess& access, const RecordedBus& bus, const TraceWindow& window) {
  const bool gap_reaches_in =
      access.is_kept() && !bus.accesses.empty() && bus.accesses.back().end() < window.to;
  return access.request >= window.to && !gap_reaches_in;
}

void add(const RecordedAccess& access, const TraceWindow& window, RecordedBus& bus) {
  if (is_beyond(access, bus, window)) {
    return;
  }
  if (access.end() <= window.from) {
    bus.accesses.clear();  // only the last one before the window matters
  }
  bus.accesses.push_back(access);
}

/// A pause that has not ended lasts for ever.
void add_pause(bool pauses, Instant instant, const TraceWindow& window,
               std::vector<RecordedPause>& of_master) {
  if (pauses) {
    of_master.push_back({instant, Instant::max()});
    return;
  }
  of_master.back().to = instant;
  if (of_master.back().to <= window.from || of_master.back().from >= window.to) {
    of_master.pop_back();
  }
}

void record_handovers(models::CcettMachine& model, BusRecord& record) {
  model.observe_handovers([&model, &record](const models::Handover& handover) {
    const Instant start = model.started().value_or(handover.sent);
    const RecordedHandover recorded{static_cast<std::uint16_t>(handover.from),
                                    static_cast<std::uint16_t>(handover.to), handover.sent - start,
                                    handover.arrived - start};
    if (recorded.sent >= record.window.from && recorded.arrived < record.window.to) {
      record.handovers.push_back(recorded);
    }
  });
}

}  // namespace

std::string backplane_name(std::size_t backplane) {
  return backplane == 0 ? "versabus" : fmt::format("versabus{}", backplane);
}

void start_record(models::CcettMachine& model, const TraceWindow& window, BusRecord& record) {
  record.window = window;
  for (std::size_t i = 0; i < model.backplanes(); ++i) {
    record.buses.push_back(
        {backplane_name(i), static_cast<int>(8 * model.bus(i).word_bytes()), {}, {}});
  }
  model.observe_bus([&model, &record](const BusAccess& access) {
    if (const auto start = model.started()) {
      const auto board = static_cast<std::size_t>(access.master);
      add(recorded(access, *start), record.window, record.buses[board % record.buses.size()]);
    }
  });
  model.observe_pauses([&model, &record](std::size_t master, bool pauses, Instant instant) {
    record.pauses.resize(std::max(record.pauses.size(), master + 1));
    add_pause(pauses, instant - model.started().value_or(instant), record.window,
              record.pauses[master]);
  });
  record_handovers(model, record);
}

void finish_record(const models::CcettMachine& model, BusRecord& record) {
  const models::MachineStatistics statistics = model.statistics();
  const Instant start = statistics.load_time;
  record.window.to = std::min(record.window.to, statistics.frame_time);
  record.window.from = std::min(record.window.from, record.window.to);
  const auto add_master = [&](const std::string& name, std::optional<Instant> finish) {
    const std::size_t i = record.boards.size();
    const std::size_t backplane = i % model.backplanes();
    const models::VersaBus& bus = model.bus(backplane);
    const int master = static_cast<int>(i / model.backplanes());
    RecordedBoard board{name, bus.master_place(master).level, {}};
    if (finish) {
      board.finish = *finish - start;
    }
    record.boards.push_back(std::move(board));
    if (const auto request = bus.standing_request(master)) {
      record.buses[backplane].standing.push_back({i, *request - start});
    }
  };
  for (std::size_t i = 0; i < statistics.boards.size(); ++i) {
    add_master(fmt::format("board{}", i), statistics.boards[i].finished);
  }
  for (const models::UnitKindStatistics& kind : statistics.units) {
    const char* name = models::k_unit_kind_names[static_cast<std::size_t>(kind.kind)];
    for (std::size_t i = 0; i < kind.units.size(); ++i) {
      add_master(fmt::format("{}{}", name, i), std::nullopt);
    }
  }
}

}  // namespace maquette::sim
