#include "models/bus/bus_account.hpp"

#include <algorithm>

namespace maquette::models {

void BusAccount::add_master() {
  statistics_.masters.emplace_back();
  const std::size_t masters = statistics_.masters.size();
  for (auto* matrix : {&statistics_.waited_for, &standing_}) {
    matrix->emplace_back();
    for (auto& row : *matrix) {
      row.resize(masters);
    }
  }
  statistics_.queue_times.resize(masters);
  queued_.resize(masters);
}

// ---- queue length ----

void BusAccount::pass_queue_time(Instant to) {
  if (queue_length_ > 0) {
    statistics_.queue_times[queue_length_ - 1] += to - queue_known_to_;
  }
  queue_known_to_ = to;
}

void BusAccount::decide(Instant instant, const Contenders& standing) {
  const auto pass_grant = [this](Instant to) {
    if (grant_ <= to) {
      pass_queue_time(grant_);
      --queue_length_;
      grant_ = k_never;
    }
  };
  for (const Contender& one : standing) {
    if (queued_[static_cast<std::size_t>(one.master)] == 0) {
      const Instant from = std::max(one.request, queue_known_to_);
      pass_grant(from);
      pass_queue_time(from);
      ++queue_length_;
      queued_[static_cast<std::size_t>(one.master)] = 1;
    }
  }
  pass_grant(instant);
  pass_queue_time(instant);
}

// ---- who waits for whom ----

void BusAccount::occupy(int master, Instant from, Instant to, const Contenders& standing) {
  for (const Contender& other : standing) {
    if (other.master != master) {
      found_occupied(other.master, master, to - std::max(other.request, from));
    }
  }
}

void BusAccount::found_occupied(int master, int occupant, Duration rest) {
  standing_[static_cast<std::size_t>(master)][static_cast<std::size_t>(occupant)] += rest;
}

void BusAccount::assign_waits(const BusAccess& access) {
  const auto index = static_cast<std::size_t>(access.master);
  for (std::size_t other = 0; other < standing_.size(); ++other) {
    statistics_.waited_for[index][other] += standing_[index][other];
    standing_[index][other] = Duration::zero();
  }
}

// ---- accesses ----

void BusAccount::record(const BusAccess& access, Instant decision) {
  const auto index = static_cast<std::size_t>(access.master);
  BusMasterStatistics& master = at(access.master);
  const Duration wait = access.grant - access.request;
  const Duration arbitration = access.grant - decision;
  ++master.transfers;
  master.busy += access.end - access.grant;
  master.arbitration += arbitration;
  master.handover += access.handover;
  master.waited += wait;
  master.waits.add(wait);
  if (wait > master.longest_wait) {
    record_longest_wait(access);
  }
  if (decision > access.request) {
    ++master.delayed;
    assign_waits(access);
  }
  statistics_.waited_for[index][index] += arbitration;
  queued_[index] = 0;
  grant_ = access.grant;
}

void BusAccount::repeat(const BusAccess& first, std::int64_t times, Duration period) {
  const auto index = static_cast<std::size_t>(first.master);
  BusMasterStatistics& master = at(first.master);
  const Duration wait = first.grant - first.request;
  const Duration transfer = first.end - first.grant;
  master.transfers += times;
  master.busy += times * transfer;
  master.arbitration += times * wait;
  master.waited += times * wait;
  master.waits.add(wait, times);
  if (first.kept) {
    master.held += times * (period - transfer);
  }
  statistics_.waited_for[index][index] += times * wait;
  pass_queue_time(grant_);
  statistics_.queue_times[0] += (times - 1) * wait;  // the last one is in the queue
  queue_known_to_ = first.decision + (times - 1) * period;
  grant_ = first.grant + (times - 1) * period;
}

void BusAccount::record_longest_wait(const BusAccess& access) {
  BusMasterStatistics& master = at(access.master);
  const auto& row = standing_[static_cast<std::size_t>(access.master)];
  const auto most = std::max_element(row.begin(), row.end());
  master.longest_wait = access.grant - access.request;
  master.longest_wait_request = access.request;
  master.longest_wait_behind =
      *most > Duration::zero() ? static_cast<int>(most - row.begin()) : k_nobody;
}

BusStatistics BusAccount::statistics() const {
  BusAccount known = *this;
  if (grant_ != k_never) {
    known.pass_queue_time(grant_);
  }
  return known.statistics_;
}

}  // namespace maquette::models
