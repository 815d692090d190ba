#include "models/board/program_time.hpp"

#include <limits>

#include "models/board/mc68000/external_bus.hpp"

namespace maquette::models {

namespace {

constexpr std::int64_t k_largest = std::numeric_limits<std::int64_t>::max();
/// Of an access without wait states; off the board the bus tells how long it takes.
constexpr std::uint64_t k_access_clocks = 4;

/// What a call costs is executed.
Kvm02Parameters without_call_overhead(Kvm02Parameters parameters) {
  parameters.call_overhead = {};
  return parameters;
}

}  // namespace

OperationCost ram_use(const mc68000::Account& account) {
  const auto own = [](std::uint64_t all, std::uint64_t off_board) {
    return static_cast<double>(all - off_board);
  };
  const std::uint64_t off_board =
      k_access_clocks * (account.bus_fetches + account.bus_reads + account.bus_writes) +
      mc68000::k_modify_cycles * account.bus_modifications;
  return {own(account.cycles, off_board),
          own(account.fetches, account.bus_fetches) + own(account.reads, account.bus_reads),
          own(account.writes, account.bus_writes)};
}

ProgramTime::ProgramTime(const Kvm02Parameters& parameters)
    : cost_(without_call_overhead(parameters)),
      read_wait_(parameters.ram_read_wait_clocks),
      write_wait_(parameters.ram_write_wait_clocks) {}

Duration ProgramTime::elapsed(const mc68000::Account& account, const firmware::Work& work) {
  const OperationCost use = ram_use(account);
  const std::int64_t clocks = static_cast<std::int64_t>(use.clocks) +
                              read_wait_ * static_cast<std::int64_t>(use.reads) +
                              write_wait_ * static_cast<std::int64_t>(use.writes);
  added_milliclocks_ += cost_.milliclocks(work);
  const Wide milliclocks = static_cast<Wide>(clocks) * k_milliclocks + added_milliclocks_;
  return milliclocks < k_largest ? cost_.elapsed(static_cast<std::int64_t>(milliclocks))
                                 : Duration::max();
}

}  // namespace maquette::models
