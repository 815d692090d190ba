#pragma once

#include <cstdint>

namespace maquette::firmware {

/// What a processor does while it synthesises a pixel. Costs (clocks, bus reads and writes) are
/// given per class: of the arithmetic by a table of models/arithmetic/, of the events by one of
/// models/program/, or both by pixels whose program was executed.
///
/// The arithmetic classes are counted by the number type `Counted`. An operand that is zero is
/// counted apart because software floating point takes a short cut on it (FFP sources, "zero
/// operand" lines). The classes from `load` on are events of the process, which the firmware
/// declares with `charge`, one line in each function that is one.
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
  load,         ///< a 32-bit word read from the scene database
  pixel,        ///< a pixel of the useful zone
  ray,          ///< a primary, reflected or refracted ray followed
  shadow_ray,   ///< a ray towards a light source
  node,         ///< a node of the tree visited by a ray
  rectangle,    ///< the rectangle of an extent compared with a pixel
  sphere,       ///< the sphere of an extent compared with a ray
  box,          ///< the box of an extent compared with a ray
  leaf,         ///< a leaf intersected by a ray
  part,         ///< a part of a primitive visited: sections, patches, edges, a triangle of terrain
  span,         ///< a span of a leaf that matters to a ray
  combination,  ///< the crossings of two operands combined
  crossing,     ///< a crossing that a combination takes
  point,        ///< a visible point brought to its surface
  light,        ///< a light source asked from a point
  facets,       ///< the micro-facets of a surface asked
  isolation,    ///< an interval, or a cell of a patch, searched for roots
  root,         ///< a root refined
  root_step     ///< a step of Laguerre's method
};

inline constexpr int k_operation_count = static_cast<int>(Operation::root_step) + 1;
/// Of these the first are arithmetic.
inline constexpr int k_arithmetic_count = static_cast<int>(Operation::load);

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
                                                                     "pixel",
                                                                     "ray",
                                                                     "shadow_ray",
                                                                     "node",
                                                                     "rectangle",
                                                                     "sphere",
                                                                     "box",
                                                                     "leaf",
                                                                     "part",
                                                                     "span",
                                                                     "combination",
                                                                     "crossing",
                                                                     "point",
                                                                     "light",
                                                                     "facets",
                                                                     "isolation",
                                                                     "root",
                                                                     "root_step"};

/// Counts per operation class, each of so many bits.
template <class Count>
struct WorkCounts {
  Count counts[k_operation_count];

  constexpr Count& operator[](Operation operation) { return counts[static_cast<int>(operation)]; }
  constexpr Count operator[](Operation operation) const {
    return counts[static_cast<int>(operation)];
  }
};

/// What a pixel (or the preprocessing) cost, never seconds.
using Work = WorkCounts<std::uint32_t>;

/// What many pixels cost, or one before it is known that it fits a Work.
using LongWork = WorkCounts<std::uint64_t>;

/// How many rays of each kind a pixel needed (paper, section V.2.3.1.2), each of so many bits.
template <class Count>
struct RayNumbers {
  Count primary;
  Count reflected;
  Count refracted;
  Count shadow;
};

using RayCounts = RayNumbers<std::uint32_t>;

/// The counts that go with a number type. A board's program, which nobody asks for them, has
/// shorter ones.
template <class Real>
struct RayCounting {
  using Counts = RayCounts;
};

template <class Real>
using RayCountsOf = typename RayCounting<Real>::Counts;

}  // namespace maquette::firmware
