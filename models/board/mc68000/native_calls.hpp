#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace maquette::models::mc68000 {

struct ExecutionUnit;

/// Routines that the host executes in place of the processor. When a subroutine is called or jumped
/// to at one of their addresses (BSR, JSR, BRA, JMP), the host's function gets the processor as it
/// is there. It does what the routine would, charges its cost, and returns from the subroutine.
class NativeCalls {
 public:
  using Function = std::function<void(ExecutionUnit&)>;

  /// Throws std::invalid_argument for an odd address, one beyond 24 bits, or one that is taken, and
  /// for more than 255 routines.
  void add(std::uint32_t address, Function function);

  [[nodiscard]] bool contains(std::uint32_t address) const {
    const std::uint32_t word = address / 2;
    return word < numbers_.size() && numbers_[word] != 0;
  }

  /// Executes the routine at an address that is contained.
  void execute(std::uint32_t address, ExecutionUnit& unit) const {
    functions_[numbers_[address / 2] - 1U](unit);
  }

 private:
  std::vector<std::uint8_t> numbers_;  // from 1, by words of the memory up to the last routine
  std::vector<Function> functions_;
};

}  // namespace maquette::models::mc68000
