#include "sim/run/contention_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include "models/bus/checked_sum.hpp"
#include "models/bus/wide.hpp"

namespace maquette::sim {

namespace {

using models::Duration;

/// A board or a function unit, as a master of the bus.
struct Master {
  std::string name;
  const models::BoardStatistics* states;
};

/// All masters but the host, in the order of their numbers.
std::vector<Master> masters_of(const models::MachineStatistics& model) {
  std::vector<Master> masters;
  for (const models::BoardStatistics& board : model.boards) {
    masters.push_back({fmt::format("board{}", masters.size()), &board});
  }
  for (const models::UnitKindStatistics& kind : model.units) {
    const char* name = models::k_unit_kind_names[static_cast<std::size_t>(kind.kind)];
    for (std::size_t i = 0; i < kind.units.size(); ++i) {
      masters.push_back({fmt::format("{}{}", name, i), &kind.units[i].states});
    }
  }
  return masters;
}

std::string name_of(int master, const std::vector<Master>& masters) {
  return master == models::k_nobody ? "nobody" : masters[static_cast<std::size_t>(master)].name;
}

double ratio(models::Wide part_ps, Duration whole) {
  return whole.count() > 0 ? static_cast<double>(part_ps) / static_cast<double>(whole.count()) : 0;
}

WaitQuantiles quantiles_of(const models::WaitHistogram& waits) {
  return {waits.quantile(500), waits.quantile(900), waits.quantile(990), waits.quantile(999)};
}

MasterStatistics master_statistics(const models::MachineStatistics& model,
                                   const std::vector<Master>& masters, std::size_t number) {
  const models::BoardStatistics& states = *masters[number].states;
  const models::BusMasterStatistics& on_bus = model.bus.masters[number];
  MasterStatistics master;
  master.name = masters[number].name;
  master.transfers = states.words;
  master.wait = states.wait_grant;
  master.wait_max = states.longest_wait;
  master.wait_quantiles = quantiles_of(on_bus.waits);
  const auto& row = model.bus.waited_for[number];
  master.waited_for.assign(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(masters.size()));
  for (const models::WaitHistogram::Bucket& bucket : on_bus.waits.buckets()) {
    master.waits.push_back({bucket.from, bucket.to, bucket.count});
  }
  if (model.has_finished && std::accumulate(master.waited_for.begin(), master.waited_for.end(),
                                            Duration{}) != master.wait) {
    throw std::logic_error(master.name + "'s waits for the others do not sum to its wait");
  }
  return master;
}

LongestWait longest_wait(const models::MachineStatistics& model,
                         const std::vector<Master>& masters) {
  LongestWait longest;
  for (std::size_t i = 0; i < masters.size(); ++i) {
    const models::BusMasterStatistics& master = model.bus.masters[i];
    const Duration requested_at = master.longest_wait_request - model.load_time;
    if (master.longest_wait > longest.time ||
        (master.longest_wait == longest.time && requested_at < longest.requested_at)) {
      longest = {master.longest_wait, requested_at, masters[i].name,
                 name_of(master.longest_wait_behind, masters)};
    }
  }
  return longest;
}

/// (sum x)^2 / (n sum x^2) of the boards' mean waits x (Jain, Chiu and Hawe 1984).
double fairness_of(const models::MachineStatistics& model) {
  double sum = 0;
  double squares = 0;
  int boards = 0;
  for (const models::BoardStatistics& board : model.boards) {
    if (board.words > 0) {
      const double mean =
          static_cast<double>(board.wait_grant.count()) / static_cast<double>(board.words);
      sum += mean;
      squares += mean * mean;
      ++boards;
    }
  }
  return squares > 0 ? sum * sum / (boards * squares) : 1;
}

/// The frame time of `buses` together.
Duration bus_time_of(const models::MachineStatistics& model, int buses) {
  Duration time{};
  for (int bus = 0; bus < buses; ++bus) {
    time = models::checked_sum(time, model.frame_time);
  }
  return time;
}

/// An interrupted bus may be ahead of the kernel: what it has granted is then the whole.
BusShares shares_of(const models::MachineStatistics& model, std::size_t masters, Duration transfer,
                    Duration bus_time) {
  Duration arbitration{};
  Duration handover{};
  Duration kept{};
  for (std::size_t i = 0; i < masters; ++i) {
    const models::BusMasterStatistics& master = model.bus.masters[i];
    arbitration = models::checked_sum(arbitration, master.arbitration - master.handover);
    handover = models::checked_sum(handover, master.handover);
    kept = models::checked_sum(kept, master.held);
  }
  const Duration occupied = models::checked_sum(models::checked_sum(transfer, arbitration),
                                                models::checked_sum(handover, kept));
  const Duration whole = std::max(bus_time, occupied);
  const auto share = [whole](Duration part) { return ratio(part.count(), whole); };
  return {share(transfer), share(arbitration), share(handover), share(kept),
          whole.count() > 0 ? share(whole - occupied) : 1};
}

/// The requests of the host, before the frame, stood alone: they are taken off the queue.
QueueStatistics queue_statistics(const models::MachineStatistics& model, std::size_t host) {
  const Duration bus_time = bus_time_of(model, model.backplanes);
  std::vector<Duration> times{bus_time};
  times.insert(times.end(), model.bus.queue_times.begin(), model.bus.queue_times.end());
  for (std::size_t i = host; i < model.bus.masters.size(); ++i) {
    times[1] -= model.bus.masters[i].waited;
  }
  models::Wide requests_ps = 0;
  QueueStatistics queue;
  for (std::size_t length = 1; length < times.size(); ++length) {
    times[0] -= times[length];
    requests_ps += static_cast<models::Wide>(times[length].count()) * length;
  }
  times[0] = std::max(times[0], Duration::zero());  // an interrupted bus may be ahead of the kernel
  queue.mean = ratio(requests_ps, bus_time);
  for (std::size_t length = 0; length < times.size(); ++length) {
    if (times[length] > Duration::zero()) {
      queue.longest = static_cast<int>(length);
      queue.times.push_back({queue.longest, times[length]});
    }
  }
  return queue;
}

}  // namespace

BusStatistics contention_statistics(const models::MachineStatistics& model, bool accesses_overlap) {
  BusStatistics bus;
  models::Wide waited_ps = 0;
  models::WaitHistogram waits;
  const std::vector<Master> masters = masters_of(model);
  for (std::size_t i = 0; i < masters.size(); ++i) {
    const models::BoardStatistics& states = *masters[i].states;
    bus.transfers += states.words;
    bus.database_words += states.database_words;
    bus.busy = models::checked_sum(bus.busy, states.transfer);
    waited_ps += states.wait_grant.count();
    bus.wait_max = std::max(bus.wait_max, states.longest_wait);
    waits.add(model.bus.masters[i].waits);
    bus.masters.push_back(master_statistics(model, masters, i));
  }
  if (bus.transfers > 0) {
    bus.wait_mean =
        Duration(static_cast<Duration::rep>((waited_ps + bus.transfers / 2) / bus.transfers));
  }
  bus.utilisation = ratio(bus.busy.count(), bus_time_of(model, model.backplanes));
  bus.buses = accesses_overlap ? static_cast<int>(masters.size()) : model.backplanes;
  bus.shares = shares_of(model, masters.size(), bus.busy, bus_time_of(model, bus.buses));
  bus.occupied = 1 - bus.shares.idle;
  bus.wait_quantiles = quantiles_of(waits);
  bus.longest_wait = longest_wait(model, masters);
  bus.fairness = fairness_of(model);
  bus.queue = queue_statistics(model, masters.size());
  return bus;
}

}  // namespace maquette::sim
