#pragma once

#include <cstdint>

namespace maquette::firmware {

/// What a processor does while it synthesises a pixel. Costs (clocks, bus reads and writes) are
/// given per operation by a table of models/arithmetic/.
///
/// The arithmetic classes are counted by the number type `Counted`. An operand that is zero is
/// counted apart because software floating point takes a short cut on it (FFP sources, "zero
/// operand" lines). The glue classes (from `load` on) are declared by the firmware with `charge`.
enum class Operation : std::uint8_t {
  add,
  subtract,
  add_zero,
  subtract_zero,
  multiply,
  multiply_zero,
  divide,
  divide_zero,
  square_root,
  compare,
  absolute,
  negate,
  integer_to_float,
  float_to_integer,
  exponential,
  power,
  arc_cosine,
  load,      ///< a 32-bit word read from the scene database
  store,     ///< a 32-bit word written to a work area
  branch,    ///< a decision on integers or flags
  loop,      ///< one iteration of a loop: index, bound, branch back
  call,      ///< one call of a firmware function and its return
  root,      ///< one call of the function that refines a root
  root_step  ///< one iteration: a step of Laguerre's method
};

inline constexpr int k_operation_count = static_cast<int>(Operation::root_step) + 1;

/// The field's name of each operation, in the order of the enumeration: keys of cost tables and of
/// `work` in stats.json.
inline constexpr const char* k_operation_names[k_operation_count] = {"add",
                                                                     "subtract",
                                                                     "add_zero",
                                                                     "subtract_zero",
                                                                     "multiply",
                                                                     "multiply_zero",
                                                                     "divide",
                                                                     "divide_zero",
                                                                     "square_root",
                                                                     "compare",
                                                                     "absolute",
                                                                     "negate",
                                                                     "integer_to_float",
                                                                     "float_to_integer",
                                                                     "exponential",
                                                                     "power",
                                                                     "arc_cosine",
                                                                     "load",
                                                                     "store",
                                                                     "branch",
                                                                     "loop",
                                                                     "call",
                                                                     "root",
                                                                     "root_step"};

/// Counts per operation class: what a pixel (or the preprocessing) cost, never seconds.
struct Work {
  std::uint32_t counts[k_operation_count];

  constexpr std::uint32_t& operator[](Operation operation) {
    return counts[static_cast<int>(operation)];
  }
  constexpr std::uint32_t operator[](Operation operation) const {
    return counts[static_cast<int>(operation)];
  }
};

/// How many rays of each kind a pixel needed (paper, section V.2.3.1.2).
struct RayCounts {
  std::uint16_t primary;
  std::uint16_t reflected;
  std::uint16_t refracted;
  std::uint16_t shadow;
};

}  // namespace maquette::firmware
