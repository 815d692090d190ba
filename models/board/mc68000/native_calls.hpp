#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

namespace maquette::models::mc68000 {

struct ExecutionUnit;

/// Routines that the host executes in place of the processor. When a subroutine is called or jumped
/// to at one of their addresses (BSR, JSR, BRA, JMP), the host's function gets the processor as it
/// is there. It does what the routine would, charges its cost, and returns from the subroutine.
class NativeCalls {
 public:
  using Function = std::function<void(ExecutionUnit&)>;

  /// Throws std::invalid_argument for an odd address, one beyond 24 bits, or one that is taken.
  void add(std::uint32_t address, Function function);

  [[nodiscard]] bool contains(std::uint32_t address) const {
    const std::uint32_t word = address / 2;
    return word / 64 < marks_.size() && (marks_[word / 64] >> (word % 64) & 1U) != 0;
  }

  /// Executes the routine at an address that is contained.
  void execute(std::uint32_t address, ExecutionUnit& unit) const { functions_.at(address)(unit); }

 private:
  std::vector<std::uint64_t> marks_;  // one bit for each word of the memory, up to the last routine
  std::map<std::uint32_t, Function> functions_;
};

}  // namespace maquette::models::mc68000
