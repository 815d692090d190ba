#pragma once

#include <cstdint>
#include <vector>

#include "models/board/mc68000/mc68000.hpp"

namespace maquette::models {

/// What a routine of the arithmetic package gave, and what it took from its first instruction to
/// its return.
struct PackageCall {
  std::uint32_t result = 0;  // D7
  mc68000::ConditionCodes conditions;
  unsigned cycles = 0;  // without wait states
  unsigned reads = 0;   // 16-bit bus cycles, program fetches included
  unsigned writes = 0;
};

/// An MC68000 that holds nothing but the arithmetic package of firmware/arithmetic/maquette_ffp.
class PackageProcessor {
 public:
  PackageProcessor();

  /// Calls the routine at an entry of firmware/arithmetic/maquette_ffp/package.hpp. Throws
  /// std::logic_error where the processor stops before the routine returns.
  PackageCall call(std::uint32_t entry, std::uint32_t d7, std::uint32_t d6 = 0);

  /// All registers; a call leaves them as the routine does.
  mc68000::Registers& registers() { return processor_.registers(); }

 private:
  std::vector<std::uint8_t> memory_;
  mc68000::NoExternalBus bus_;
  mc68000::Mc68000 processor_;
};

}  // namespace maquette::models
