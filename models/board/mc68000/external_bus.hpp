#pragma once

#include <cstdint>

#include "models/board/mc68000/account.hpp"
#include "models/board/mc68000/instruction_cost.hpp"
#include "models/board/mc68000/operand_size.hpp"

namespace maquette::models::mc68000 {

/// What a processor asks of what lies outside of its RAM.
struct BusRequest {
  enum class Kind : std::uint8_t {
    fetch,
    read,
    write,
    test_and_set,  // read a byte and set its highest bit in one bus cycle (TAS)
  };

  Kind kind;
  OperandSize size;        // a byte or a word: a long word is two requests
  std::uint32_t address;   // 24 bits, even unless the size is a byte
  std::uint32_t value;     // to be written
  InstructionCost before;  // what the instruction has used when the access begins
};

/// Cycles of TAS between its read and its write, which are one bus cycle.
constexpr unsigned k_modify_cycles = 2;

struct BusReply {
  std::uint32_t value = 0;   // that was read
  unsigned wait_cycles = 0;  // beyond the four cycles of an access
  bool error = false;        // a bus error: the processor stops within the instruction
  bool pause = false;        // the processor is to stop after the instruction
};

/// What lies outside of a processor's RAM. Accesses are rare, so a virtual call does no harm; a
/// SystemC process may let time pass in it.
class ExternalBus {
 public:
  virtual ~ExternalBus() = default;

  /// Performs an access. `account` is that of the processor when it began the instruction.
  virtual BusReply access(const BusRequest& request, const Account& account) = 0;
};

/// A bus where nothing answers.
class NoExternalBus final : public ExternalBus {
 public:
  BusReply access(const BusRequest& /*request*/, const Account& /*account*/) override {
    BusReply reply;
    reply.error = true;
    return reply;
  }
};

}  // namespace maquette::models::mc68000
