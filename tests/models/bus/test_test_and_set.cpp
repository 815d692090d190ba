#include <vector>

#include "models/board/shared_memory.hpp"
#include "models/bus/bus_burst.hpp"
#include "tests/catch.hpp"
#include "tests/models/bus/traffic.hpp"

namespace {

using namespace maquette::models;
using namespace maquette::models::traffic;

constexpr Duration k_clock{125'000};
constexpr Duration k_access = 7 * k_clock;  // of a memory of 250 ns

// Two memory-sharing masters without a machine around them.
struct Rig {
  explicit Rig(const VersaBusParameters& parameters)
      : bus("bus", parameters), memory("memory", {Duration{250'000}}, 16, 1) {
    bus.attach_slave(memory.bus_ports[0], {"memory", 0x1000, memory.size_bytes()});
    bus.observe([this](const BusAccess& access) { log.push_back(access); });
  }

  VersaBus bus;
  SharedMemory memory;
  std::vector<BusAccess> log;
};

// A master that tests and sets one word after the other, and keeps what it read.
class Taker : public sc_core::sc_module {
 public:
  Taker(const sc_core::sc_module_name& name, VersaBus& bus, std::vector<std::uint64_t> addresses)
      : sc_module(name),
        socket("socket"),
        bus_(bus),
        id_(bus.attach_master(socket, {this->name(), {0, 0}, board_access()})),
        addresses_(std::move(addresses)) {
    SC_HAS_PROCESS(Taker);
    SC_THREAD(run);
  }

  tlm_utils::simple_initiator_socket<Taker> socket;
  std::vector<unsigned char> read;

 private:
  void run() {
    BusBurst burst(tlm::TLM_READ_COMMAND);
    burst.transaction.test_and_set = true;
    burst.transaction.modify = 2 * k_clock;
    for (const std::uint64_t address : addresses_) {
      burst.bytes.assign(bus_.word_bytes(), 0);
      burst.aim(address);
      sc_core::sc_time delay = sc_core::SC_ZERO_TIME;
      socket->b_transport(burst.payload, delay);
      CHECK(burst.payload.is_response_ok());
      read.push_back(burst.bytes.front());
    }
    bus_.retire(id_);
  }

  VersaBus& bus_;
  int id_;
  std::vector<std::uint64_t> addresses_;
};

TEST_CASE("test-and-set reads what was there and leaves the top bit, in one access") {
  Rig rig({});
  Taker taker("taker", rig.bus, {0x1000, 0x1000, 0x1004, 0x1000});
  sc_core::sc_start();
  CHECK(taker.read == std::vector<unsigned char>{0, 0x80, 0, 0x80});
  REQUIRE(rig.log.size() == 4);
  for (const BusAccess& access : rig.log) {
    CHECK(access.end - access.grant == 2 * k_access + 2 * k_clock);
    CHECK(access.grant - access.request == 4 * k_clock);
  }
}

TEST_CASE("no higher level comes between the read and the write of test-and-set") {
  Rig rig({});
  Taker taker("taker", rig.bus, {0x1000});
  traffic::Master higher("higher", rig.bus, {4, 0}, board_access(), Style::waiting,
                         script({{10 * k_clock, 0x1008}}));
  sc_core::sc_start();
  REQUIRE(rig.log.size() == 2);
  CHECK(rig.log[0].master == 0);
  CHECK(rig.log[1].request == 10 * k_clock);
  CHECK(rig.log[1].grant == rig.log[0].end + 5 * k_clock);
}

}  // namespace
