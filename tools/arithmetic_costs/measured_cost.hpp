#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace maquette::costs {

/// What an operation takes over random operands: 68000 clocks without wait states, 16-bit bus reads
/// (program fetches included) and writes.
struct MeasuredCost {
  double mean = 0;
  double deviation = 0;
  std::uint64_t least = 0;
  std::uint64_t most = 0;
  double reads = 0;
  double writes = 0;
};

/// What one execution takes.
struct Execution {
  std::uint64_t cycles = 0;
  std::uint64_t reads = 0;
  std::uint64_t writes = 0;
};

MeasuredCost measure(int executions, const std::function<Execution()>& execute);

/// A row of a table of models/arithmetic/.
struct CostRow {
  std::string operation;  // its name in the table
  MeasuredCost cost;
  bool called = true;  // or in line
  char mark = 'M';
  std::string source;
};

/// All operations of the package, in the order of the tables. Always the same figures.
std::vector<CostRow> measured_rows();

}  // namespace maquette::costs
