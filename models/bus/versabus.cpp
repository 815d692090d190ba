#include "models/bus/versabus.hpp"

#include <stdexcept>

#include "models/bus/kernel_time.hpp"

namespace maquette::models {

namespace {

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

}  // namespace

VersaBus::VersaBus(const sc_core::sc_module_name& name, const VersaBusParameters& parameters)
    : sc_module(name),
      master_sockets_("master_sockets"),
      word_bytes_(static_cast<unsigned>(parameters.data_width_bits / k_bits_per_byte)),
      slaves_(parameters.timeout),
      masters_(word_bytes_, account_) {
  check(parameters);
  engine_ = parameters.level.make_engine(parameters, {masters_, slaves_, account_});
  master_sockets_.register_b_transport(this, &VersaBus::b_transport);
  master_sockets_.register_transport_dbg(this, &VersaBus::transport_dbg);
}

int VersaBus::attach_master(tlm::tlm_base_initiator_socket<>& socket, const BusMaster& master) {
  const int number = masters_.add(master);
  socket.bind(master_sockets_);
  return number;
}

void VersaBus::retire(int master) {
  masters_.lookahead().retire(master, kernel_now());
  engine_->advance();
}

void VersaBus::activate(int master) { masters_.lookahead().activate(master, kernel_now()); }

void VersaBus::promise(int master, Instant instant) {
  masters_.lookahead().promise(master, instant, kernel_now());
  engine_->advance();
}

void VersaBus::rest(int master) {
  masters_.lookahead().rest(master, kernel_now());
  engine_->advance();
}

void VersaBus::stir(int master) { masters_.lookahead().stir(master, kernel_now()); }

void VersaBus::expect(int bystander, Instant instant) {
  masters_.lookahead().expect(bystander, instant);
  engine_->advance();
}

void VersaBus::b_transport(int id, tlm::tlm_generic_payload& burst, sc_core::sc_time& delay) {
  const Instant request = kernel_now() + to_duration(delay);
  masters_.post(id, burst, request);
  engine_->enter(id, request);
  engine_->advance();
  masters_.await(id);
  delay = sc_core::SC_ZERO_TIME;
}

unsigned VersaBus::transport_dbg(int /*id*/, tlm::tlm_generic_payload& payload) {
  return slaves_.transport_dbg(payload);
}

int VersaBus::longest_standing() const {
  int longest = k_nobody;
  Instant earliest = k_never;
  for (int id = 0; id < masters_.count(); ++id) {
    const Instant request = standing_request(id).value_or(k_never);
    if (request < earliest) {
      earliest = request;
      longest = id;
    }
  }
  return longest;
}

}  // namespace maquette::models
