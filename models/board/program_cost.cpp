#include "models/board/program_cost.hpp"

namespace maquette::models {

namespace {

constexpr std::int64_t k_milliclocks = 1'000;
/// Of an access without wait states.
constexpr std::int64_t k_access_clocks = 4;

std::int64_t difference(std::uint64_t all, std::uint64_t others) {
  return static_cast<std::int64_t>(all - others);
}

}  // namespace

std::int64_t program_milliclocks(const mc68000::Account& account, const Kvm02Parameters& board) {
  const std::uint64_t off_board = account.bus_fetches + account.bus_reads + account.bus_writes;
  const std::int64_t ram_reads = difference(account.fetches, account.bus_fetches) +
                                 difference(account.reads, account.bus_reads);
  const std::int64_t ram_writes = difference(account.writes, account.bus_writes);
  return k_milliclocks *
         (difference(account.cycles, k_access_clocks * off_board) +
          board.ram_read_wait_clocks * ram_reads + board.ram_write_wait_clocks * ram_writes);
}

}  // namespace maquette::models
