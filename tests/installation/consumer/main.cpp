#include <tlm_utils/simple_initiator_socket.h>
#include <tlm_utils/simple_target_socket.h>
#include <cstdio>
#include <systemc>

#include "models/bus/versabus.hpp"

// Someone else's program: two masters of its own on the VERSAbus, and a memory. Both ask for the
// bus at the same instants; the one of the higher level gets it first.

namespace {

using namespace maquette::models;

constexpr int k_accesses = 10;

/// Four clocks of 8 MHz, as a 68000 accesses memory that costs no wait.
const AccessLaw k_access{Period::of_frequency(8e6), 4, Duration::zero()};

class Memory : public sc_core::sc_module {
 public:
  explicit Memory(const sc_core::sc_module_name& name) : sc_module(name) {
    socket.register_b_transport(this, &Memory::b_transport);
  }
  tlm_utils::simple_target_socket<Memory> socket{"socket"};

 private:
  void b_transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    delay += sc_core::sc_time(250, sc_core::SC_NS);
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }
};

class Master : public sc_core::sc_module {
 public:
  Master(const sc_core::sc_module_name& name, VersaBus& bus, int level)
      : sc_module(name), bus_(bus) {
    number_ = bus.attach_master(socket, {this->name(), {level, 0}, k_access});
    sc_core::sc_spawn([this] { work(); });
  }
  tlm_utils::simple_initiator_socket<Master> socket{"socket"};

 private:
  void work() {
    for (int access = 0; access < k_accesses; ++access) {
      unsigned char word[2] = {};
      tlm::tlm_generic_payload payload;
      payload.set_command(tlm::TLM_WRITE_COMMAND);
      payload.set_address(0x100);
      payload.set_data_ptr(word);
      payload.set_data_length(sizeof word);
      payload.set_streaming_width(sizeof word);
      sc_core::sc_time computed(10, sc_core::SC_US);
      socket->b_transport(payload, computed);
      if (payload.is_response_error()) {
        SC_REPORT_ERROR(name(), "a bus error");
      }
    }
    bus_.retire(number_);
  }

  VersaBus& bus_;
  int number_ = 0;
};

}  // namespace

int sc_main(int /*argc*/, char** /*argv*/) {
  VersaBus bus("bus", {});
  Memory memory("memory");
  bus.attach_slave(memory.socket, {"memory", 0, 0x1000});
  Master high("high", bus, 2);
  Master low("low", bus, 1);
  sc_core::sc_start();

  const BusStatistics statistics = bus.statistics();
  for (std::size_t i = 0; i < statistics.masters.size(); ++i) {
    const BusMasterStatistics& master = statistics.masters[i];
    std::printf("%s: %lld grants, waited %lld ps, %lld of them behind the other\n",
                bus.master_name(static_cast<int>(i)).c_str(),
                static_cast<long long>(master.transfers),
                static_cast<long long>(master.waited.count()),
                static_cast<long long>(statistics.waited_for[i][1 - i].count()));
  }
  const bool all_granted = statistics.masters[0].transfers == k_accesses &&
                           statistics.masters[1].transfers == k_accesses;
  const bool low_waited = statistics.waited_for[1][0] > Duration::zero() &&
                          statistics.waited_for[0][1] == Duration::zero();
  return all_granted && low_waited ? 0 : 1;
}
