#include "sim/trace/vcd_bus.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include "sim/trace/board_states.hpp"

namespace maquette::sim {

namespace {

using models::Instant;

constexpr int k_levels = 5;
constexpr int k_owner_bits = 16;
constexpr int k_state_bits = 2;
static_assert(static_cast<int>(BoardState::idle) < 1 << k_state_bits);

/// As many as the bus has, or more where an address takes them.
int address_bits(const RecordedBus& bus) {
  constexpr int k_bus_bits = 32;
  constexpr int k_most_bits = 64;
  const bool fit =
      std::all_of(bus.accesses.begin(), bus.accesses.end(), [](const RecordedAccess& access) {
        return access.address <= std::numeric_limits<std::uint32_t>::max();
      });
  return fit ? k_bus_bits : k_most_bits;
}

constexpr std::uint16_t after(std::uint16_t signal, int places) {
  return static_cast<std::uint16_t>(signal + places);
}

struct BusSignals {
  BusSignals(VcdDump& dump, const RecordedBus& bus)
      : request(levels(dump, bus.name, "BR")),
        grant(levels(dump, bus.name, "BG")),
        busy(dump.add(bus.name, "BBSY_n", SignalKind::active_low)),
        address_strobe(dump.add(bus.name, "AS_n", SignalKind::active_low)),
        data_strobe(dump.add(bus.name, "DS_n", SignalKind::active_low)),
        acknowledge(dump.add(bus.name, "DTACK_n", SignalKind::active_low)),
        error(dump.add(bus.name, "BERR_n", SignalKind::active_low)),
        write(dump.add(bus.name, "WRITE_n", SignalKind::vector)),
        address(dump.add(bus.name, "address", SignalKind::vector, address_bits(bus))),
        data(dump.add(bus.name, "data", SignalKind::vector, bus.data_bits)),
        owner(dump.add(bus.name, "owner", SignalKind::vector, k_owner_bits)) {}

  // The number of the first of five.
  static std::uint16_t levels(VcdDump& dump, const std::string& scope, const char* name) {
    const auto first = static_cast<std::uint16_t>(dump.signals.size());
    for (int level = 0; level < k_levels; ++level) {
      dump.add(scope, fmt::format("{}{}_n", name, level), SignalKind::active_low);
    }
    return first;
  }

  std::uint16_t request;
  std::uint16_t grant;
  std::uint16_t busy;
  std::uint16_t address_strobe;
  std::uint16_t data_strobe;
  std::uint16_t acknowledge;
  std::uint16_t error;
  std::uint16_t write;
  std::uint16_t address;
  std::uint16_t data;
  std::uint16_t owner;
};

void dump_access(VcdDump& dump, const BusSignals& bus, const RecordedAccess& access, int level) {
  const Instant end = access.end();
  dump.assert_during(after(bus.request, level), access.request, access.grant);
  dump.assert_during(after(bus.grant, level), access.decision(), access.grant);
  dump.assert_during(bus.busy, access.grant, end);
  dump.assert_during(bus.address_strobe, access.grant, end);
  dump.assert_during(bus.data_strobe, access.grant, end);
  dump.assert_during(access.is_answered() ? bus.acknowledge : bus.error,
                     access.grant + access.acknowledge, end);
  dump.set(bus.write, access.grant, access.write != 0 ? 0 : 1);
  dump.set(bus.address, access.grant, access.address);
  dump.set(bus.data, access.grant, access.data);
  dump.set(bus.owner, access.grant, access.board);
  for (const std::uint16_t lines : {bus.write, bus.address, bus.data, bus.owner}) {
    dump.release(lines, end);
  }
}

/// Before which nothing of each access, and of those after it, changes: requests come in another
/// order than grants.
std::vector<Instant> beginnings(const std::vector<RecordedAccess>& accesses) {
  std::vector<Instant> result(accesses.size() + 1, models::k_never);
  for (std::size_t i = accesses.size(); i-- > 0;) {
    const RecordedAccess& access = accesses[i];
    const Instant kept = access.is_kept() && i > 0 ? accesses[i - 1].end() : access.request;
    result[i] = std::min({result[i + 1], access.request, access.decision(), kept});
  }
  return result;
}

void dump_kept(VcdDump& dump, const BusSignals& bus, const RecordedAccess& before,
               const RecordedAccess& access) {
  dump.assert_during(bus.busy, before.end(), access.decision());
  dump.set(bus.owner, before.end(), before.board);
  dump.release(bus.owner, access.decision());
}

}  // namespace

std::vector<ChangeSource> dump_bus(const BusRecord& record, const RecordedBus& bus, VcdDump& dump) {
  const BusSignals signals(dump, bus);
  const auto level = [&record](std::size_t board) { return record.boards[board].level; };
  const auto tell_standing = [&record, &bus, &dump, signals, level] {
    for (const StandingRequest& standing : bus.standing) {
      dump.assert_during(after(signals.request, level(standing.board)), standing.request,
                         record.window.to);
    }
    return models::k_never;
  };
  const auto next = std::make_shared<const std::vector<Instant>>(beginnings(bus.accesses));
  const auto tell_access = [&bus, &dump, signals, level, next, i = std::size_t{0}]() mutable {
    const RecordedAccess& access = bus.accesses[i];
    if (access.is_kept() && i > 0) {
      dump_kept(dump, signals, bus.accesses[i - 1], access);
    }
    dump_access(dump, signals, access, level(access.board));
    return (*next)[++i];
  };
  return {{Instant::min(), tell_standing}, {next->front(), tell_access}};
}

ChangeSource dump_board(const BusRecord& record, std::size_t board, VcdDump& dump) {
  const std::string& scope = record.boards[board].name;
  const std::uint16_t state = dump.add(scope, scope + "_state", SignalKind::vector, k_state_bits);
  const std::uint16_t request = dump.add(scope, scope + "_BR_n", SignalKind::active_low);
  const auto states =
      std::make_shared<const std::vector<StateInterval>>(board_states(record, board));
  return source_of(*states, [states, &dump, state, request](const StateInterval& interval) {
    dump.set(state, interval.from, static_cast<std::uint64_t>(interval.state));
    if (interval.state == BoardState::wait_grant) {
      dump.assert_during(request, interval.from, interval.to);
    }
  });
}

}  // namespace maquette::sim
