#include "models/bus/versabus.hpp"

#include <stdexcept>

#include "models/bus/bus_misuse.hpp"
#include "models/bus/kernel_time.hpp"
#include "models/bus/time_limit.hpp"

namespace maquette::models {

namespace {

constexpr int k_levels = 5;
constexpr int k_bits_per_byte = 8;

void check(const VersaBusParameters& parameters) {
  const int width = parameters.data_width_bits;
  if (width != 16 && width != 32) {
    throw std::invalid_argument("the data width of a VERSAbus is 16 or 32 bits");
  }
  if (parameters.arbitration_clocks < 0 || parameters.handover_clocks < 0 ||
      parameters.timeout < Duration::zero()) {
    throw std::invalid_argument("times of a VERSAbus must not be negative");
  }
  if (parameters.quantum < Duration::zero()) {
    throw std::invalid_argument("the quantum of a bus must not be negative");
  }
}

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

VersaBus::VersaBus(const sc_core::sc_module_name& name, const VersaBusParameters& parameters)
    : sc_module(name),
      master_sockets_("master_sockets"),
      slaves_(parameters.timeout),
      word_bytes_(static_cast<unsigned>(parameters.data_width_bits / k_bits_per_byte)),
      wake_("wake") {
  check(parameters);
  arbiter_ = parameters.level.make_arbiter(parameters, account_);
  master_sockets_.register_b_transport(this, &VersaBus::b_transport);
  master_sockets_.register_transport_dbg(this, &VersaBus::transport_dbg);
  SC_HAS_PROCESS(VersaBus);
  SC_METHOD(advance);
  sensitive << wake_;
  dont_initialize();
}

// ---- masters come and go ----

void VersaBus::check_place(const BusMaster& master) const {
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

int VersaBus::attach_master(tlm::tlm_base_initiator_socket<>& socket, const BusMaster& master) {
  check_place(master);
  if (master.access.access_clocks < 1) {
    throw std::invalid_argument("an access of master " + master.name + " must take a clock");
  }
  socket.bind(master_sockets_);
  masters_.push_back(std::make_unique<Master>(master, word_bytes_));
  lookahead_.add_master(master.name);
  account_.add_master();
  return static_cast<int>(masters_.size()) - 1;
}

void VersaBus::retire(int master) {
  lookahead_.retire(master, kernel_now());
  advance();
}

void VersaBus::activate(int master) { lookahead_.activate(master, kernel_now()); }

void VersaBus::b_transport(int id, tlm::tlm_generic_payload& burst, sc_core::sc_time& delay) {
  const Instant request = kernel_now() + to_duration(delay);
  lookahead_.post(id, request, kernel_now());
  at(id).burst.begin(burst, at(id).description.name);
  enter(id, request);
  advance();
  sc_core::wait(at(id).completed);
  delay = sc_core::SC_ZERO_TIME;
}

unsigned VersaBus::transport_dbg(int /*id*/, tlm::tlm_generic_payload& payload) {
  return slaves_.transport_dbg(payload);
}

int VersaBus::longest_standing() const {
  int longest = k_nobody;
  Instant earliest = k_never;
  for (std::size_t id = 0; id < masters_.size(); ++id) {
    const Instant request = standing_request(static_cast<int>(id)).value_or(k_never);
    if (request < earliest) {
      earliest = request;
      longest = static_cast<int>(id);
    }
  }
  return longest;
}

void VersaBus::enter(int id, Instant request) {
  lookahead_.request_next(id, request);
  arbiter_->enter({id, at(id).description.place, request});
}

// ---- the bus's own time ----

// Takes every decision that may be taken, in the process of whoever calls: a master, which has
// posted or retires, or the bus's own method, woken.
void VersaBus::advance() {
  const Instant now = kernel_now();
  for (Instant next = arbiter_->next_decision(); next != k_never;
       next = arbiter_->next_decision()) {
    const Instant from = lookahead_.decidable_from(next, arbiter_->heeds_unknown(), now);
    if (from > now) {
      if (from != k_never) {
        wake_.notify(to_sc_time(from - now));
      }
      return;
    }
    lookahead_.decide(next);
    access(arbiter_->decide());
  }
}

void VersaBus::access(const BusGrant& granted) {
  Master& master = at(granted.master);
  BusTransaction& transaction = master.burst.transaction();
  const AccessResult result =
      slaves_.access(master.burst, master.description.access, granted.grant);
  require_in_time(granted.grant, result.duration, master.description.name);
  const BusAccess access{granted.master,
                         master.burst.address(),
                         master.burst.burst().is_write(),
                         granted.request,
                         granted.grant,
                         granted.grant + result.duration,
                         granted.decision,
                         result.slave_time,
                         result.status == tlm::TLM_OK_RESPONSE,
                         granted.kept,
                         transaction.test_and_set,
                         observer_ ? master.burst.word() : 0};
  check_order(access, master.description.name);
  arbiter_->release(granted, access.end,
                    transaction.block && access.answered && master.burst.has_more());
  account_.record(access, access.decision);
  answer(transaction, access);
  if (observer_) {
    observer_(access);
  }
  finish_access(access, result.status);
}

void VersaBus::finish_access(const BusAccess& access, tlm::tlm_response_status status) {
  BurstProgress& burst = at(access.master).burst;
  const bool has_more = access.answered && burst.has_more();
  burst.pass_access();
  if (has_more) {
    enter(access.master, access.end + burst.transaction().next_gap());
    return;
  }
  if (!access.answered) {
    account_.fail(access.master);
    burst.transaction().failed_address = access.address;
  }
  complete(access.master, access.end, status);
}

// Ends a burst, or lets the next one follow it up.
void VersaBus::complete(int id, Instant end, tlm::tlm_response_status status) {
  Master& master = at(id);
  tlm::tlm_generic_payload& burst = master.burst.burst();
  const BusTransaction& transaction = master.burst.transaction();
  burst.set_response_status(status);
  if (status == tlm::TLM_OK_RESPONSE && transaction.follow_up) {
    if (const std::optional<Duration> until = transaction.follow_up(end)) {
      master.burst.begin(burst, master.description.name);
      enter(id, end + *until);
      return;
    }
  }
  lookahead_.end(id, end, transaction.runs_ahead);
  master.completed.notify(to_sc_time(end - kernel_now()));
}

}  // namespace maquette::models
