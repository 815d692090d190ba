#include "models/bus/bus_masters.hpp"

#include <stdexcept>

#include "models/bus/bus_misuse.hpp"
#include "models/bus/kernel_time.hpp"
#include "models/bus/time_limit.hpp"

namespace maquette::models {

namespace {

constexpr int k_levels = 5;

void check_order(const BusAccess& access, const std::string& master) {
  if (access.request > access.decision || access.decision > access.grant ||
      access.grant >= access.end) {
    report_misuse("an access of master " + master + " runs backwards");
  }
}

// Puts an access into what the bus answers its master.
void answer(BusTransaction& transaction, const BusAccess& access) {
  const Duration wait = access.grant - access.request;
  transaction.waited += wait;
  transaction.transferred += access.end - access.grant;
  if (wait > transaction.longest_wait) {
    transaction.longest_wait = wait;
    transaction.longest_wait_request = access.request;
  }
}

}  // namespace

void BusMasters::check_place(const BusMaster& master) const {
  if (master.place.level < 0 || master.place.level >= k_levels) {
    throw std::invalid_argument("master " + master.name + " must have a level from 0 to 4");
  }
  for (const auto& other : masters_) {
    const BusMasterPlace& place = other->description.place;
    if (place.level == master.place.level && place.position == master.place.position) {
      throw std::invalid_argument("master " + master.name + " has the place of master " +
                                  other->description.name);
    }
  }
}

int BusMasters::add(const BusMaster& master) {
  check_place(master);
  if (master.access.access_clocks < 1) {
    throw std::invalid_argument("an access of master " + master.name + " must take a clock");
  }
  masters_.push_back(std::make_unique<Master>(master, word_bytes_));
  lookahead_.add_master(master.name);
  account_.add_master();
  return count() - 1;
}

void BusMasters::post(int master, tlm::tlm_generic_payload& burst, Instant request) {
  if (request < kernel_now()) {
    report_misuse("master " + at(master).description.name + " requests in the past");
  }
  lookahead_.post(master, request, kernel_now());
  at(master).burst.begin(burst, at(master).description.name);
}

// ---- one access ----

BusAccess BusMasters::access_of(const BusGrant& granted, const AccessResult& result) const {
  BurstProgress& burst = at(granted.master).burst;
  require_in_time(granted.grant, result.duration, at(granted.master).description.name);
  return {granted.master,
          burst.address(),
          burst.burst().is_write(),
          granted.request,
          granted.grant,
          granted.grant + result.duration,
          granted.decision,
          result.slave_time,
          result.status == tlm::TLM_OK_RESPONSE,
          granted.kept,
          burst.transaction().test_and_set,
          observer_ ? burst.word() : 0,
          granted.handover};
}

bool BusMasters::keeps_bus(const BusAccess& access) const {
  BurstProgress& burst = at(access.master).burst;
  return burst.transaction().block && access.answered && burst.has_more();
}

std::optional<Instant> BusMasters::finish(const BusAccess& access,
                                          tlm::tlm_response_status status) {
  Master& master = at(access.master);
  check_order(access, master.description.name);
  account_.record(access, access.decision);
  BusTransaction& transaction = master.burst.transaction();
  answer(transaction, access);
  if (observer_) {
    observer_(access);
  }
  const bool has_more = access.answered && master.burst.has_more();
  master.burst.pass_access();
  if (has_more) {
    return requested(access.master, access.end + transaction.next_gap());
  }
  if (!access.answered) {
    account_.fail(access.master);
    transaction.failed_address = access.address;
  }
  return complete(access.master, access.end, status);
}

std::optional<Instant> BusMasters::repeat(const BusAccess& first, std::int64_t times,
                                          Duration period) {
  Master& master = at(first.master);
  account_.repeat(first, times, period);
  BusTransaction& transaction = master.burst.transaction();
  transaction.waited += times * (first.grant - first.request);
  transaction.transferred += times * (first.end - first.grant);
  transaction.accesses += times;
  return master.burst.has_ended()
             ? complete(first.master, first.end + (times - 1) * period, tlm::TLM_OK_RESPONSE)
             : requested(first.master, first.request + times * period);
}

std::optional<Instant> BusMasters::requested(int master, Instant request) {
  lookahead_.request_next(master, request);
  return request;
}

// Ends a burst, or lets the next one follow it up.
std::optional<Instant> BusMasters::complete(int id, Instant end, tlm::tlm_response_status status) {
  Master& master = at(id);
  tlm::tlm_generic_payload& burst = master.burst.burst();
  const BusTransaction& transaction = master.burst.transaction();
  burst.set_response_status(status);
  if (status == tlm::TLM_OK_RESPONSE && transaction.follow_up) {
    if (const std::optional<Duration> until = transaction.follow_up(end)) {
      master.burst.begin(burst, master.description.name);
      return requested(id, end + *until);
    }
  }
  lookahead_.end(id, end, transaction.runs_ahead);
  master.completed.notify(to_sc_time(end - kernel_now()));
  return std::nullopt;
}

}  // namespace maquette::models
