#pragma once

#include <cstdint>

#include "models/board/mc68000/cycle_counter.hpp"
#include "models/board/mc68000/memory_interface.hpp"
#include "models/board/mc68000/native_calls.hpp"
#include "models/board/mc68000/registers.hpp"
#include "models/board/mc68000/stop.hpp"

namespace maquette::models::mc68000 {

/// What instructions work on.
struct ExecutionUnit {
  ExecutionUnit(Ram ram, ExternalBus& bus) : memory(ram, bus, counter) {}
  ExecutionUnit(const ExecutionUnit&) = delete;
  ExecutionUnit& operator=(const ExecutionUnit&) = delete;
  ~ExecutionUnit() = default;

  /// The next word of the program.
  [[gnu::always_inline]] std::uint16_t fetch() {
    const std::uint16_t word = memory.fetch(registers.program_counter);
    registers.program_counter += 2;
    return word;
  }

  std::uint32_t fetch_long() {
    const std::uint32_t high = fetch();
    return high << 16U | fetch();
  }

  /// `before` is what the instruction has used when it pushes.
  void push(std::uint32_t value, PackedCost before) {
    registers.stack() -= 4;
    memory.write<OperandSize::long_word>(registers.stack(), value, before);
  }

  /// `before` is what the instruction has used when it pops.
  template <OperandSize size>
  Operand<size> pop(PackedCost before = 0) {
    const Operand<size> value = memory.read<size>(registers.stack(), before);
    registers.stack() += bytes_of(size);
    return value;
  }

  /// Throws Fault for an odd address, where no instruction can be.
  static void check_target(std::uint32_t target) {
    if ((target & 1U) != 0) {
      throw Fault{StopReason::odd_address, target};
    }
  }

  /// Throws as check_target().
  void jump(std::uint32_t target) {
    check_target(target);
    registers.program_counter = target;
  }

  /// Jumps to where a subroutine may begin, which the host may execute. Throws as jump().
  void enter(std::uint32_t target) {
    jump(target);
    if (native_calls != nullptr && native_calls->contains(target)) {
      native_calls->execute(target, *this);
    }
  }

  void return_from_subroutine(PackedCost before = 0) { jump(pop<OperandSize::long_word>(before)); }

  /// Throws Fault in user mode.
  void require_supervisor() const {
    if (!registers.supervisor) {
      throw Fault{StopReason::privilege_violation};
    }
  }

  Registers registers;
  CycleCounter counter;
  MemoryInterface memory;
  const NativeCalls* native_calls = nullptr;
};

}  // namespace maquette::models::mc68000
