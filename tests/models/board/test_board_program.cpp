#include "models/board/board_program.hpp"

#include <memory>
#include <vector>

#include "tests/catch.hpp"

using namespace maquette::models;
using Kind = ProgramEvent::Kind;
using Request = mc68000::BusRequest;

namespace {

constexpr std::uint32_t k_start = 0x400;
constexpr std::uint32_t k_stack = 0x800;
constexpr std::uint32_t k_nowhere = 0x700;

/// RAM with a program of words at its start address.
std::vector<std::uint8_t> ram_with(const std::vector<std::uint16_t>& words) {
  std::vector<std::uint8_t> ram(0x1000);
  std::uint32_t address = k_start;
  for (const std::uint16_t word : words) {
    ram[address++] = static_cast<std::uint8_t>(word >> 8U);
    ram[address++] = static_cast<std::uint8_t>(word);
  }
  return ram;
}

mc68000::Ram view(std::vector<std::uint8_t>& ram) {
  return {ram.data(), static_cast<std::uint32_t>(ram.size())};
}

/// MOVE.W #value,$800000; MOVE.W $900000,D0; MOVE.W D0,$800002; STOP
const std::vector<std::uint16_t> k_write_read_write = {
    0x33FC, 0x1234, 0x0080, 0x0000, 0x3039, 0x0090, 0x0000, 0x33C0, 0x0080, 0x0002, 0x4E72, 0x2700};

TEST_CASE("accesses off the board come in order, at their cycles, and reads get their answers") {
  std::vector<std::uint8_t> ram = ram_with(k_write_read_write);
  ProgramSlots slots(1);
  BoardProgram program(view(ram), {k_start, k_stack, k_nowhere}, {}, slots);

  ProgramEvent event = program.next();
  REQUIRE(event.kind == Kind::access);
  CHECK(event.request.kind == Request::Kind::write);
  CHECK(event.request.address == 0x800000);
  CHECK(event.request.value == 0x1234);
  CHECK(event.account.cycles == 0);
  CHECK(event.request.before.cycles == 12);  // the value and the address are fetched
  event = program.next();
  REQUIRE(event.kind == Kind::access);
  CHECK(event.request.kind == Request::Kind::read);
  CHECK(event.request.address == 0x900000);
  CHECK(event.account.cycles == 20);  // MOVE.W #,xxx.L: 20(4/1)
  CHECK(event.request.before.cycles == 8);
  program.answer(0xABCD);
  event = program.next();
  REQUIRE(event.kind == Kind::access);
  CHECK(event.request.value == 0xABCD);
  CHECK(event.account.cycles == 20 + 16);  // MOVE.W xxx.L,Dn: 16(4/0)
  event = program.next();
  REQUIRE(event.kind == Kind::end);
  CHECK(event.stop.reason == mc68000::StopReason::stop_instruction);
  CHECK(event.account.cycles == 20 + 16 + 16);  // MOVE.W Dn,xxx.L: 16(3/1)
  CHECK(event.account.bus_writes == 2);
  CHECK(event.account.bus_reads == 1);
}

TEST_CASE("what goes wrong in a program is its end") {
  std::vector<std::uint8_t> ram = ram_with({0x4EF8, 0x0401});  // JMP $0401
  ProgramSlots slots(1);
  BoardProgram program(view(ram), {k_start, k_stack, k_nowhere}, {}, slots);
  const ProgramEvent event = program.next();
  CHECK(event.kind == Kind::end);
  CHECK(event.stop.reason == mc68000::StopReason::odd_address);
  CHECK(event.stop.instruction_address == k_start);
}

TEST_CASE("the routine where synthesis begins is told, and executed") {
  // BSR to the routine behind; STOP; the routine: MOVE.W #7,$800000; RTS
  std::vector<std::uint8_t> ram =
      ram_with({0x6104, 0x4E72, 0x2700, 0x33FC, 0x0007, 0x0080, 0x0000, 0x4E75});
  ProgramSlots slots(1);
  BoardProgram program(view(ram), {k_start, k_stack, k_start + 6}, {}, slots);
  ProgramEvent event = program.next();
  CHECK(event.kind == Kind::synthesis);
  event = program.next();
  REQUIRE(event.kind == Kind::access);
  CHECK(event.request.value == 7);
  CHECK(program.next().kind == Kind::end);
}

TEST_CASE("routines of the host are counted between events") {
  constexpr std::uint32_t k_routine = 0x600;
  // BSR.W to the routine, twice; MOVE.W #7,$800000; BSR.W; STOP
  const auto call = [](std::uint32_t at) {
    return static_cast<std::uint16_t>(k_routine - (k_start + at + 2));
  };
  std::vector<std::uint8_t> ram = ram_with({0x6100, call(0), 0x6100, call(4), 0x33FC, 0x0007,
                                            0x0080, 0x0000, 0x6100, call(16), 0x4E72, 0x2700});
  ProgramSlots slots(1);
  const HostRoutines routines = [](mc68000::NativeCalls& calls, maquette::firmware::Work& work) {
    calls.add(k_routine, [&work](mc68000::ExecutionUnit& unit) {
      ++work[maquette::firmware::Operation::multiply];
      unit.return_from_subroutine();
    });
  };
  BoardProgram program(view(ram), {k_start, k_stack, k_nowhere}, routines, slots);
  CHECK(program.next().work[maquette::firmware::Operation::multiply] == 2);
  const ProgramEvent end = program.next();
  CHECK(end.kind == Kind::end);
  CHECK(end.work[maquette::firmware::Operation::multiply] == 1);
}

/// MOVE.W D0,$800000; ADDQ.W #1,D0; BRA to the start: writes for ever.
const std::vector<std::uint16_t> k_endless = {0x33C0, 0x0080, 0x0000, 0x5240, 0x60F6};

TEST_CASE("programs share the host's threads, and each can be left at any event") {
  for (const int threads : {1, 2, 5}) {
    ProgramSlots slots(threads);
    std::vector<std::vector<std::uint8_t>> rams(4, ram_with(k_endless));
    std::vector<std::unique_ptr<BoardProgram>> programs;
    for (auto& ram : rams) {
      programs.push_back(std::make_unique<BoardProgram>(
          view(ram), ProgramEntry{k_start, k_stack, k_nowhere}, HostRoutines{}, slots));
    }
    for (std::uint32_t i = 0; i < 1000; ++i) {
      for (const auto& program : programs) {
        const ProgramEvent event = program->next();
        REQUIRE(event.request.value == i);
        REQUIRE(event.account.cycles == i * (16 + 4 + 10));
      }
    }
  }
}

}  // namespace
