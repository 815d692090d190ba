#include "models/bus/versabus.hpp"

#include <algorithm>
#include <chrono>
#include <optional>
#include <stdexcept>

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

namespace {

constexpr int k_levels = 5;
constexpr int k_bits_per_byte = 8;
/// The bus goes no further ahead of the kernel, so that a run can be watched and ended.
constexpr Duration k_horizon = std::chrono::seconds(1);
constexpr unsigned char k_taken = 0x80;  // what TAS sets
constexpr const char* k_report = "/maquette/versabus";

// Throws out of the kernel's run.
void fail(const std::string& what) { SC_REPORT_ERROR(k_report, what.c_str()); }

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

}  // namespace

VersaBus::VersaBus(const sc_core::sc_module_name& name, const VersaBusParameters& parameters)
    : sc_module(name),
      master_sockets_("master_sockets"),
      slave_sockets_("slave_sockets"),
      word_bytes_(static_cast<unsigned>(parameters.data_width_bits / k_bits_per_byte)),
      timeout_(parameters.timeout),
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

int VersaBus::attach_master(tlm::tlm_base_initiator_socket<>& socket, const BusMaster& master) {
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
  if (master.access.access_clocks < 1) {
    throw std::invalid_argument("an access of master " + master.name + " must take a clock");
  }
  socket.bind(master_sockets_);
  masters_.push_back(std::make_unique<Master>(master));
  Master& added = *masters_.back();
  added.access.set_extension(&added.strobe);
  added.access.set_data_length(word_bytes_);
  added.access.set_streaming_width(word_bytes_);
  ++computing_;
  ++unpromised_;
  account_.add_master();
  return static_cast<int>(masters_.size()) - 1;
}

void VersaBus::attach_slave(tlm::tlm_base_target_socket<>& socket, const AddressRange& range) {
  address_map_.add(range);
  slave_sockets_.bind(socket);
}

const std::string& VersaBus::master_name(int master) const {
  return masters_[static_cast<std::size_t>(master)]->description.name;
}

std::optional<Instant> VersaBus::standing_request(int master) const {
  const Master& one = at(master);
  return one.state == State::requesting ? std::optional(one.request) : std::nullopt;
}

// ---- masters come and go ----

void VersaBus::b_transport(int id, tlm::tlm_generic_payload& burst, sc_core::sc_time& delay) {
  post(id, burst, kernel_now() + to_duration(delay));
  advance();
  sc_core::wait(at(id).completed);
  delay = sc_core::SC_ZERO_TIME;
}

unsigned VersaBus::transport_dbg(int /*id*/, tlm::tlm_generic_payload& payload) {
  const std::uint64_t address = payload.get_address();
  const int slave = address_map_.find(address);
  if (slave == AddressMap::k_unmapped) {
    payload.set_response_status(tlm::TLM_ADDRESS_ERROR_RESPONSE);
    return 0;
  }
  payload.set_address(address - address_map_[slave].base);
  const unsigned bytes = slave_sockets_[slave]->transport_dbg(payload);
  payload.set_address(address);
  return bytes;
}

void VersaBus::post(int id, tlm::tlm_generic_payload& burst, Instant request) {
  leave_computing(id, State::requesting);
  begin(id, burst, request);
}

void VersaBus::begin(int id, tlm::tlm_generic_payload& burst, Instant request) {
  Master& master = at(id);
  if (burst.get_data_length() == 0 || burst.get_data_length() % word_bytes_ != 0) {
    fail("a burst of " + master.description.name + " is not a whole number of bus words");
  }
  auto* transaction = burst.get_extension<BusTransaction>();
  master.transaction = transaction != nullptr ? transaction : &master.plain;
  master.burst = &burst;
  master.accesses = static_cast<std::int64_t>(burst.get_data_length() / word_bytes_);
  master.transaction->accesses = 0;
  master.transaction->waited = master.transaction->transferred = Duration::zero();
  master.transaction->longest_wait = Duration::zero();
  if (const auto given = static_cast<std::int64_t>(master.transaction->addresses.size());
      given != 0 && given != master.accesses) {
    fail("a burst of " + master.description.name + " needs one address per access");
  }
  burst.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  master.access.set_command(burst.get_command());
  enter(id, request);
}

void VersaBus::enter(int id, Instant request) {
  Master& master = at(id);
  master.request = request;
  arbiter_->enter({id, master.description.place, request});
}

void VersaBus::leave_computing(int id, State next) {
  Master& master = at(id);
  if (master.state != State::computing) {
    fail("master " + master.description.name + " is retired or has a transaction already");
  }
  if (master.promised && master.completed_at != kernel_now()) {
    fail("master " + master.description.name + " broke its promise to run ahead");
  }
  master.state = next;
  --computing_;
  unpromised_ -= master.promised ? 0 : 1;
  master.promised = false;
}

void VersaBus::retire(int master) {
  leave_computing(master, State::retired);
  advance();
}

void VersaBus::activate(int master) {
  if (at(master).state != State::retired) {
    fail("only a retired master can be activated");
  }
  if (last_decision_ >= kernel_now()) {
    fail("the bus has run ahead of the activation of a master");
  }
  at(master).state = State::computing;
  ++computing_;
  ++unpromised_;
}

// ---- the bus's own time ----

void VersaBus::advance() {
  const Instant now = kernel_now();
  for (Instant next = arbiter_->next_decision(); next != k_never;
       next = arbiter_->next_decision()) {
    if (computing_ > 0 && next >= now && arbiter_->heeds_unknown()) {
      if (unpromised_ > 0) {
        wake_.notify(to_sc_time(next + k_tick - now));
      }
      return;
    }
    if (next >= now + k_horizon) {
      wake_.notify(to_sc_time(next - now));
      return;
    }
    last_decision_ = std::max(last_decision_, next);
    transfer(arbiter_->decide());
  }
}

// ---- one access ----

std::uint64_t VersaBus::next_address(const Master& master) const {
  const auto& transaction = *master.transaction;
  const auto index = static_cast<std::uint64_t>(transaction.accesses);
  return transaction.addresses.empty() ? master.burst->get_address() + index * word_bytes_
                                       : transaction.addresses[index];
}

void VersaBus::transfer(const BusGrant& granted) {
  Master& master = at(granted.master);
  const std::uint64_t address = next_address(master);
  BusTransaction& transaction = *master.transaction;
  const AccessResult result = transaction.test_and_set
                                  ? test_and_set(master, address, granted.grant)
                                  : access_slave(master, address, granted.grant);
  const BusAccess access{granted.master,
                         address,
                         master.burst->is_write(),
                         granted.request,
                         granted.grant,
                         granted.grant + result.duration,
                         granted.decision,
                         result.slave_time,
                         result.status == tlm::TLM_OK_RESPONSE,
                         granted.kept,
                         transaction.test_and_set,
                         observer_ ? word_of(master) : 0};
  if (access.request > access.decision || access.decision > access.grant ||
      access.grant >= access.end) {
    fail("an access of master " + master.description.name + " runs backwards");
  }
  const bool has_more = access.answered && transaction.accesses + 1 < master.accesses;
  arbiter_->release(granted, access.end, transaction.block && has_more);
  account_.record(access, access.decision);
  answer(transaction, access);
  if (observer_) {
    observer_(access);
  }
  finish_access(access, result.status);
}

std::uint32_t VersaBus::word_of(const Master& master) const {
  const unsigned char* byte = master.burst->get_data_ptr() +
                              static_cast<std::size_t>(master.transaction->accesses) * word_bytes_;
  std::uint32_t word = 0;
  for (unsigned i = 0; i < word_bytes_; ++i) {
    word = word << static_cast<unsigned>(k_bits_per_byte) | *byte++;
  }
  return word;
}

void VersaBus::answer(BusTransaction& transaction, const BusAccess& access) {
  const Duration wait = access.grant - access.request;
  transaction.waited += wait;
  transaction.transferred += access.end - access.grant;
  if (wait > transaction.longest_wait) {
    transaction.longest_wait = wait;
    transaction.longest_wait_request = access.request;
  }
}

VersaBus::AccessResult VersaBus::access_slave(Master& master, std::uint64_t address,
                                              Instant strobe) {
  const Duration unanswered =
      timeout_ > Duration::zero() ? timeout_ : master.description.access.duration({});
  const int slave = address_map_.find(address);
  if (slave == AddressMap::k_unmapped) {
    return {unanswered, unanswered, tlm::TLM_ADDRESS_ERROR_RESPONSE};
  }
  tlm::tlm_generic_payload& access = master.access;
  access.set_address(address - address_map_[slave].base);
  access.set_data_ptr(master.burst->get_data_ptr() +
                      static_cast<std::size_t>(master.transaction->accesses) * word_bytes_);
  access.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  master.strobe.instant = strobe;

  const Duration offset = std::max(strobe - kernel_now(), Duration::zero());
  sc_core::sc_time delay = to_sc_time(offset);
  slave_sockets_[slave]->b_transport(access, delay);
  const Duration slave_time = to_duration(delay) - offset;
  if (timeout_ > Duration::zero() && slave_time > timeout_) {
    return {timeout_, timeout_, tlm::TLM_GENERIC_ERROR_RESPONSE};
  }
  return {master.description.access.duration(slave_time), slave_time, access.get_response_status()};
}

VersaBus::AccessResult VersaBus::test_and_set(Master& master, std::uint64_t address,
                                              Instant strobe) {
  unsigned char& first_byte =
      master.burst
          ->get_data_ptr()[static_cast<std::size_t>(master.transaction->accesses * word_bytes_)];
  master.access.set_command(tlm::TLM_READ_COMMAND);
  const AccessResult read = access_slave(master, address, strobe);
  if (read.status != tlm::TLM_OK_RESPONSE) {
    return read;
  }
  const unsigned char value = first_byte;
  const Duration until_write = read.duration + master.transaction->modify;
  first_byte = static_cast<unsigned char>(value | k_taken);
  master.access.set_command(tlm::TLM_WRITE_COMMAND);
  const AccessResult write = access_slave(master, address, strobe + until_write);
  first_byte = value;
  const bool is_written = write.status == tlm::TLM_OK_RESPONSE;
  return {until_write + write.duration,
          is_written ? read.slave_time : until_write + write.slave_time, write.status};
}

void VersaBus::finish_access(const BusAccess& access, tlm::tlm_response_status status) {
  Master& master = at(access.master);
  BusTransaction& transaction = *master.transaction;
  ++transaction.accesses;
  if (!access.answered) {
    account_.fail(access.master);
    transaction.failed_address = access.address;
    complete(access.master, access.end, status);
  } else if (transaction.accesses == master.accesses) {
    complete(access.master, access.end, status);
  } else {
    enter(access.master, access.end + transaction.next_gap());
  }
}

void VersaBus::complete(int id, Instant end, tlm::tlm_response_status status) {
  Master& master = at(id);
  master.burst->set_response_status(status);
  if (status == tlm::TLM_OK_RESPONSE && master.transaction->follow_up) {
    if (const std::optional<Duration> until = master.transaction->follow_up(end)) {
      begin(id, *master.burst, end + *until);
      return;
    }
  }
  master.state = State::computing;
  master.promised = master.transaction->runs_ahead;
  master.completed_at = end;
  ++computing_;
  unpromised_ += master.promised ? 0 : 1;
  master.completed.notify(to_sc_time(end - kernel_now()));
}

}  // namespace maquette::models
