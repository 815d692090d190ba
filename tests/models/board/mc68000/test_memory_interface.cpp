#include "models/board/mc68000/memory_interface.hpp"

#include <stdexcept>

#include "tests/catch.hpp"
#include "tests/models/board/mc68000/recording_bus.hpp"
#include "tests/models/board/mc68000/small_board.hpp"

namespace {

using namespace maquette::tests;
using namespace maquette::models::mc68000;
using Kind = BusRequest::Kind;

constexpr std::uint32_t k_ram = 0x2000;

/// A RAM of 8 KiB, and a bus around it.
struct Fixture {
  std::vector<std::uint8_t> bytes = std::vector<std::uint8_t>(k_ram);
  RecordingBus bus;
  Mc68000 processor{{bytes.data(), k_ram}, bus};

  Stop execute(std::initializer_list<unsigned> words) {
    std::uint32_t address = 0x1000;
    for (const unsigned word : words) {
      bytes[address++] = static_cast<std::uint8_t>(word >> 8U);
      bytes[address++] = static_cast<std::uint8_t>(word);
    }
    processor.registers().program_counter = 0x1000;
    return processor.step();
  }
};

TEST_CASE("what is outside of the RAM goes over the bus, with size, direction and value") {
  Fixture fixture;
  fixture.processor.registers().data(0) = 0x1122'3344;
  fixture.processor.registers().address(0) = 0xab30'0000;  // of which 24 bits count
  fixture.execute({0x2080});
  fixture.execute({0x3210});
  fixture.execute({0x1428, 0x0003});
  REQUIRE(fixture.bus.requests.size() == 4);
  CHECK(fixture.bus.requests[0].kind == Kind::write);
  CHECK(fixture.bus.requests[0].size == OperandSize::word);
  CHECK(fixture.bus.requests[0].address == 0x30'0000);
  CHECK(fixture.bus.requests[0].value == 0x1122);
  CHECK(fixture.bus.requests[1].address == 0x30'0002);
  CHECK(fixture.bus.requests[1].value == 0x3344);
  CHECK(fixture.bus.requests[2].kind == Kind::read);
  CHECK(fixture.bus.requests[2].size == OperandSize::word);
  CHECK(fixture.bus.requests[3].size == OperandSize::byte);
  CHECK(fixture.bus.requests[3].address == 0x30'0003);
  CHECK(fixture.processor.registers().data(1) == 0x1122);
  CHECK(fixture.processor.registers().data(2) == 0x44);
  CHECK(fixture.bus.cycles == std::vector<std::uint64_t>{0, 0, 12, 20});
  CHECK(fixture.processor.account().bus_writes == 2);
  CHECK(fixture.processor.account().bus_reads == 2);
  CHECK(fixture.processor.account().bus_fetches == 0);
}

TEST_CASE("wait states of the bus are cycles") {
  Fixture fixture;
  fixture.bus.reply.wait_cycles = 7;
  fixture.processor.registers().address(0) = 0x30'0000;
  fixture.execute({0x3210});
  CHECK(fixture.processor.account().cycles == 8 + 7);
  CHECK(fixture.processor.account().bus_wait_cycles == 7);
}

TEST_CASE("a bus error stops the processor at its instruction") {
  Fixture fixture;
  fixture.bus.reply.error = true;
  fixture.processor.registers().address(0) = 0x30'0000;
  const Stop stop = fixture.execute({0x3210});
  CHECK(stop.reason == StopReason::bus_error);
  CHECK(stop.access_address == 0x30'0000);
  CHECK(stop.instruction_address == 0x1000);
}

TEST_CASE("a pause of the bus lets the instruction end") {
  Fixture fixture;
  fixture.bus.reply.pause = true;
  fixture.processor.registers().address(0) = 0x30'0000;
  fixture.execute({0x4e71});
  fixture.bytes[0x1000] = 0x32;  // MOVE.W (A0),D1 and then NOP
  fixture.bytes[0x1001] = 0x10;
  fixture.bytes[0x1002] = 0x4e;
  fixture.bytes[0x1003] = 0x71;
  fixture.processor.registers().program_counter = 0x1000;
  const Stop stop = fixture.processor.run({1000});
  CHECK(stop.reason == StopReason::bus_pause);
  CHECK(stop.instruction_address == 0x1002);
  CHECK(fixture.processor.run({fixture.processor.account().cycles + 4}).reason ==
        StopReason::cycle_limit);
}

TEST_CASE("TAS over the bus is one request") {
  Fixture fixture;
  fixture.processor.registers().address(0) = 0x30'0001;
  fixture.execute({0x4ad0});
  CHECK(fixture.processor.registers().conditions.zero());
  fixture.execute({0x4ad0});
  CHECK(fixture.processor.registers().conditions.negative());
  REQUIRE(fixture.bus.requests.size() == 2);
  CHECK(fixture.bus.requests[0].kind == Kind::test_and_set);
  CHECK(fixture.bus.memory[0x30'0001] == 0x80);
  CHECK(fixture.processor.account().bus_reads == 2);
  CHECK(fixture.processor.account().bus_writes == 2);
}

TEST_CASE("a long word across the end of the RAM is two words, one over the bus") {
  Fixture fixture;
  for (const std::uint32_t address : {k_ram - 2, 0xff'fffeU}) {
    const bool at_end = address < k_ram;
    fixture.bus.requests.clear();
    fixture.processor.registers().address(0) = address;
    fixture.processor.registers().data(0) = 0x1122'3344;
    fixture.execute({0x2080});
    fixture.execute({0x2210});
    CHECK(fixture.processor.registers().data(1) == 0x1122'3344);
    REQUIRE(fixture.bus.requests.size() == 2);
    CHECK(fixture.bus.requests[0].size == OperandSize::word);
    CHECK(fixture.bus.requests[0].address == (at_end ? k_ram : address));
    CHECK(fixture.bus.requests[0].value == (at_end ? 0x3344U : 0x1122U));
    CHECK(fixture.bytes[at_end ? k_ram - 1 : 1] == (at_end ? 0x22 : 0x44));
  }
}

TEST_CASE("a program may run behind the bus, and in RAM beyond 24 bits") {
  Fixture fixture;
  fixture.bus.memory[0xf0'0000] = 0x70;  // MOVEQ #5,D0
  fixture.bus.memory[0xf0'0001] = 0x05;
  fixture.processor.registers().program_counter = 0xf0'0000;
  CHECK(fixture.processor.step().reason == StopReason::cycle_limit);
  CHECK(fixture.processor.registers().data(0) == 5);
  CHECK(fixture.processor.account().bus_fetches == 1);
  CHECK(fixture.bus.requests[0].kind == Kind::fetch);
  fixture.execute({0x7007});
  fixture.processor.registers().program_counter = 0x0100'1000;
  CHECK(fixture.processor.step().reason == StopReason::cycle_limit);
  CHECK(fixture.processor.registers().data(0) == 7);
}

TEST_CASE("RAM of an odd size or of more than 16 MiB is refused") {
  RecordingBus bus;
  std::vector<std::uint8_t> bytes(4);
  CHECK_THROWS_AS(Mc68000({bytes.data(), 3}, bus), std::invalid_argument);
  CHECK_THROWS_AS(Mc68000({bytes.data(), 0x100'0002}, bus), std::invalid_argument);
}

}  // namespace
