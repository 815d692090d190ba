#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "models/board/mc68000/execution_unit.hpp"
#include "models/board/mc68000/stop.hpp"

namespace maquette::models::mc68000 {

/// How far a processor is to run.
struct RunLimit {
  /// Begins no instruction once the account's cycles have reached this.
  std::uint64_t cycles = std::numeric_limits<std::uint64_t>::max();
  /// Does not execute the instruction at this address.
  std::optional<std::uint32_t> stop_address = std::nullopt;
};

/// An MC68000, executed instruction by instruction, with the cycles and bus accesses of the MC68000
/// User's Manual. It is strict: what makes an exception on an MC68000 stops it with a reason, since
/// a board's firmware is never meant to do that. There are no interrupts. It begins in supervisor
/// mode, all registers zero.
class Mc68000 {
 public:
  /// RAM and bus have to outlive the processor. Throws std::invalid_argument as MemoryInterface.
  Mc68000(Ram ram, ExternalBus& bus) : unit_(ram, bus) {}

  /// Has the host execute routines, which have to outlive the processor.
  void use(const NativeCalls& native_calls) { unit_.native_calls = &native_calls; }

  /// Executes instructions until a limit, an error, or a pause that the bus asks for. A process
  /// that shares time with others calls it again and again with a later limit.
  Stop run(const RunLimit& limit);

  /// Executes one instruction. The reason is cycle_limit when all went well.
  Stop step() { return run({account().cycles + 1}); }

  [[nodiscard]] Registers& registers() { return unit_.registers; }
  [[nodiscard]] const Registers& registers() const { return unit_.registers; }

  /// What was used until now, instructions that stopped in an error left out.
  [[nodiscard]] const Account& account() const { return unit_.counter.account(); }

 private:
  ExecutionUnit unit_;
};

}  // namespace maquette::models::mc68000
