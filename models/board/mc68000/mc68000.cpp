#include "models/board/mc68000/mc68000.hpp"

#include "models/board/mc68000/decoder_table.hpp"

namespace maquette::models::mc68000 {

namespace {

/// The instruction that is being executed, for reports.
struct CurrentInstruction {
  std::uint32_t address = 0;
  std::uint16_t word = 0;
};

template <bool with_stop_address>
void run_slice(ExecutionUnit& unit, CurrentInstruction& current, std::uint32_t stop_address) {
  const DecoderTable& table = decoder_table();
  while (unit.counter.slice_goes_on()) {
    if (with_stop_address && unit.registers.program_counter == stop_address) {
      return;
    }
    current.address = unit.registers.program_counter;
    current.word = unit.fetch();
    const DecodedInstruction& instruction = table[current.word];
    instruction.execute(unit, current.word);
    unit.counter.charge(instruction.cost);
  }
}

Stop run_until(ExecutionUnit& unit, CurrentInstruction& current, const RunLimit& limit) {
  while (true) {
    const std::uint32_t here = unit.registers.program_counter;
    if (unit.memory.take_pause()) {
      return {StopReason::bus_pause, here};
    }
    if (limit.stop_address == here) {
      return {StopReason::stop_address, here};
    }
    if (unit.counter.account().cycles >= limit.cycles) {
      return {StopReason::cycle_limit, here};
    }
    unit.counter.begin_slice(limit.cycles);
    if (limit.stop_address) {
      run_slice<true>(unit, current, *limit.stop_address);
    } else {
      run_slice<false>(unit, current, 0);
    }
    unit.counter.settle();
  }
}

}  // namespace

Stop Mc68000::run(const RunLimit& limit) {
  CurrentInstruction current;
  try {
    return run_until(unit_, current, limit);
  } catch (const Fault& fault) {
    unit_.counter.settle();
    unit_.registers.program_counter = current.address;
    return {fault.reason, current.address, current.word, fault.access_address};
  }
}

}  // namespace maquette::models::mc68000
