#include "sim/stability/counted_transfers.hpp"

#include <fmt/format.h>

#include "models/bus/arbitration_policies.hpp"
#include "models/bus/queueing_arbiter.hpp"
#include "models/bus/wide.hpp"
#include "sim/stability/tally.hpp"

namespace maquette::sim {

namespace {

using models::Duration;
using models::Instant;

constexpr int k_master_counts[] = {1, 4};
constexpr int k_cases = 2;

/// Transfers of some masters of which each requests again at the end of its access.
class SaturatedBus {
 public:
  explicit SaturatedBus(int masters)
      : masters_(masters), arbiter_(parameters(), Duration::zero(), account_) {
    for (int master = 0; master < masters; ++master) {
      account_.add_master();
      arbiter_.enter({master, {0, master}, Instant{}});
    }
  }

  /// The end of the last of them.
  Instant transfer(std::int64_t count, Duration access) {
    Instant end{};
    for (std::int64_t number = 0; number < count; ++number) {
      const models::BusGrant granted = arbiter_.decide();
      end = granted.grant + access;
      arbiter_.release(granted, end, false);
      account_.record({granted.master, 0, true, granted.request, granted.grant, end},
                      granted.decision);
      arbiter_.enter({granted.master, {0, granted.master}, end});
    }
    return end;
  }

  [[nodiscard]] models::BusStatistics statistics() const { return account_.statistics(); }

  [[nodiscard]] static Duration arbitration() { return Duration{4 * 125'000}; }

  /// Between accesses of several masters in turn.
  [[nodiscard]] Duration handover() const { return Duration{masters_ > 1 ? 125'000 : 0}; }

 private:
  static models::VersaBusParameters parameters() {
    models::VersaBusParameters parameters;
    parameters.arbitration = models::k_round_robin;
    return parameters;
  }

  int masters_;
  models::BusAccount account_;
  models::QueueingArbiter arbiter_;
};

struct TickTally {
  double off[k_cases] = {};

  void operator+=(const TickTally& other) {
    for (int i = 0; i < k_cases; ++i) {
      off[i] += other.off[i];
    }
  }
};

/// What the account of all masters comes to.
struct Sums {
  models::Wide transfers = 0;
  models::Wide busy = 0;
  models::Wide arbitration = 0;
  models::Wide waited = 0;
};

Sums sums_of(const models::BusStatistics& statistics) {
  Sums sums;
  for (const models::BusMasterStatistics& master : statistics.masters) {
    sums.transfers += master.transfers;
    sums.busy += master.busy.count();
    sums.arbitration += master.arbitration.count();
    sums.waited += master.waited.count();
  }
  return sums;
}

double apart(models::Wide a, models::Wide b) { return static_cast<double>(a > b ? a - b : b - a); }

/// Ticks and transfers that the account and the closed form differ by. The first transfer has no
/// hand-over; the first ones of the masters have stood since instant 0, all others since the end of
/// their master's last.
double ticks_off(int masters, std::int64_t transfers) {
  SaturatedBus bus(masters);
  const models::Wide first = SaturatedBus::arbitration().count();
  const models::Wide between = (SaturatedBus::arbitration() + bus.handover()).count();
  const models::Wide turn = (models::k_longest_run / transfers - models::k_tick).count() | 1;
  const models::Wide access = turn - between;
  const Instant end = bus.transfer(transfers, Duration{static_cast<Duration::rep>(access)});
  const Sums sums = sums_of(bus.statistics());
  models::Wide waited = (transfers - masters) * ((masters - 1) * turn + between);
  for (int master = 0; master < masters; ++master) {
    waited += first + master * turn;
  }
  const models::Wide arbitration = first + (transfers - 1) * between;
  return apart(end.count(), transfers * access + arbitration) + apart(sums.transfers, transfers) +
         apart(sums.busy, transfers * access) + apart(sums.arbitration, arbitration) +
         apart(sums.waited, waited);
}

}  // namespace

std::vector<StabilityRow> counted_transfer_rows(std::int64_t transfers) {
  const auto tally = tally_over<TickTally>(k_cases, [transfers](int number, TickTally& sum) {
    sum.off[number] += ticks_off(k_master_counts[number], transfers);
  });
  std::vector<StabilityRow> rows;
  rows.reserve(k_cases);
  for (int i = 0; i < k_cases; ++i) {
    rows.push_back(
        {"machines",
         fmt::format("{} transfers in 100 days, masters: {}", transfers, k_master_counts[i]),
         "ticks and transfers off the closed form", tally.off[i], 0});
  }
  return rows;
}

}  // namespace maquette::sim
