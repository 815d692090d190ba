#include "models/board/program_time.hpp"

#include <limits>

namespace maquette::models {

namespace {

constexpr std::int64_t k_milliclocks = 1'000;
constexpr std::int64_t k_largest = std::numeric_limits<std::int64_t>::max();
/// Of an access without wait states; off the board the bus tells how long it takes.
constexpr std::int64_t k_access_clocks = 4;

/// What a call costs is executed.
Kvm02Parameters without_call_overhead(Kvm02Parameters parameters) {
  parameters.call_overhead = {};
  return parameters;
}

}  // namespace

ProgramTime::ProgramTime(const Kvm02Parameters& parameters)
    : cost_(without_call_overhead(parameters)),
      read_wait_(parameters.ram_read_wait_clocks),
      write_wait_(parameters.ram_write_wait_clocks) {}

Duration ProgramTime::elapsed(const mc68000::Account& account, const firmware::Work& work) {
  const auto count = [](std::uint64_t all, std::uint64_t others) {
    return static_cast<std::int64_t>(all - others);
  };
  const std::uint64_t off_board = account.bus_fetches + account.bus_reads + account.bus_writes;
  const std::int64_t clocks = count(account.cycles, k_access_clocks * off_board) +
                              read_wait_ * (count(account.fetches, account.bus_fetches) +
                                            count(account.reads, account.bus_reads)) +
                              write_wait_ * count(account.writes, account.bus_writes);
  work_milliclocks_ += cost_.milliclocks(work);
  const Wide milliclocks = static_cast<Wide>(clocks) * k_milliclocks + work_milliclocks_;
  return milliclocks < k_largest ? cost_.elapsed(static_cast<std::int64_t>(milliclocks))
                                 : Duration::max();
}

}  // namespace maquette::models
