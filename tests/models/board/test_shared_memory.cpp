#include "models/board/shared_memory.hpp"

#include <tlm_utils/simple_initiator_socket.h>
#include <array>
#include <cstdint>
#include <stdexcept>

#include "models/bus/kernel_time.hpp"
#include "tests/catch.hpp"

using namespace maquette::models;

namespace {

/// A port of a backplane, without the bus behind it.
struct Port : sc_core::sc_module {
  explicit Port(const sc_core::sc_module_name& name) : sc_module(name), socket("socket") {}
  tlm_utils::simple_initiator_socket<Port> socket;
};

using Word = std::array<unsigned char, 2>;

/// One access to a word.
struct Access {
  Access(tlm::tlm_command command, std::uint64_t address, const Word& written = {})
      : word(written) {
    payload.set_command(command);
    payload.set_address(address);
    payload.set_data_ptr(word.data());
    payload.set_data_length(static_cast<unsigned>(word.size()));
    payload.set_streaming_width(static_cast<unsigned>(word.size()));
  }

  Word word;
  tlm::tlm_generic_payload payload;
};

}  // namespace

TEST_CASE("what one port of the shared memory writes every port reads, each access in its time") {
  const Duration access_time{250'000};
  SharedMemory memory("memory", {access_time}, 8, 2);
  Port one("one");
  Port other("other");
  one.socket.bind(memory.bus_ports[0]);
  other.socket.bind(memory.bus_ports[1]);
  sc_core::sc_start(sc_core::SC_ZERO_TIME);

  const Word written{0x12, 0x34};
  Access write(tlm::TLM_WRITE_COMMAND, 6, written);
  sc_core::sc_time delay = to_sc_time(Duration{1000});
  one.socket->b_transport(write.payload, delay);
  CHECK(write.payload.is_response_ok());
  CHECK(to_duration(delay) == Duration{1000} + access_time);

  Access look(tlm::TLM_READ_COMMAND, 6);
  CHECK(other.socket->transport_dbg(look.payload) == written.size());
  CHECK(look.word == written);
  Access read(tlm::TLM_READ_COMMAND, 6);
  other.socket->b_transport(read.payload, delay);
  CHECK(read.word == written);
  CHECK(to_duration(delay) == Duration{1000} + 2 * access_time);

  // The other words are still zero, and there is nothing behind the last one.
  Access before(tlm::TLM_READ_COMMAND, 4, written);
  other.socket->b_transport(before.payload, delay);
  CHECK(before.word == Word{});
  Access behind(tlm::TLM_READ_COMMAND, 7);
  other.socket->b_transport(behind.payload, delay);
  CHECK(behind.payload.is_response_error());
}

TEST_CASE("a shared memory that answers before it is asked is refused") {
  CHECK_THROWS_AS(SharedMemory("memory", {Duration{-1}}, 8, 1), std::invalid_argument);
}
