#pragma once

#include <cstdint>

namespace maquette::models::mc68000 {

/// Why a processor stopped. The first three are what it was asked for; the others are what the
/// firmware of a board never does, and what an MC68000 would answer with an exception.
enum class StopReason : std::uint8_t {
  cycle_limit,
  stop_address,
  bus_pause,  // the bus asked for it; the instruction is done
  odd_address,
  bus_error,
  illegal_instruction,
  later_encoding,  // an index word or a branch that only later processors of the family read so
  line_a,
  line_f,
  privilege_violation,
  trace,
  divide_by_zero,
  bounds_check,   // CHK
  overflow_trap,  // TRAPV
  trap,           // TRAP
  stop_instruction,
  reset_instruction,
};

/// The reason as a message names it.
const char* name_of(StopReason reason);

/// How a run ended. For the first three reasons the address is that of the next instruction; for
/// the others that of the instruction that could not be executed, to which the program counter is
/// set back. Other registers may hold parts of what it did.
struct Stop {
  StopReason reason = StopReason::cycle_limit;
  std::uint32_t instruction_address = 0;
  std::uint16_t instruction_word = 0;
  std::uint32_t access_address = 0;  // of odd addresses and bus errors
};

/// Thrown by an instruction that cannot be executed, and caught where instructions are counted.
struct Fault {
  StopReason reason;
  std::uint32_t access_address = 0;
};

}  // namespace maquette::models::mc68000
