#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include "firmware/arithmetic/extent_use.hpp"
#include "firmware/arithmetic/function.hpp"
#include "firmware/arithmetic/leg.hpp"
#include "firmware/arithmetic/root_steps.hpp"
#include "firmware/arithmetic/work.hpp"

/// Where `Counted` counts: by kind of ray and function, each pair of which is a cell.
namespace maquette::firmware {

/// So many kinds of primitives have a place, as k_primitive_kind_limit says.
inline constexpr std::uint32_t k_metered_primitives = 32;
inline constexpr std::uint32_t k_function_count = k_fixed_function_count + k_metered_primitives;
inline constexpr std::uint32_t k_ray_kind_count = k_ray_kind_limit;
inline constexpr std::uint32_t k_cell_count = k_ray_kind_count * k_function_count;

/// More rays never wait at once: scenes have at most 1000 in a row.
inline constexpr std::uint32_t k_waiting_rays = 1024;

/// Calls `visit` with the place of each bit.
template <class Visit>
void for_each_bit(std::uint64_t bits, Visit visit) {
  for (; bits != 0; bits &= bits - 1) {
    visit(static_cast<std::uint32_t>(__builtin_ctzll(bits)));
  }
}

/// What a host thread's `Counted` arithmetic has done since the last reset. Here `add`, `subtract`,
/// `multiply`, `divide` hold all operations, those with a zero operand too.
struct CountedMeter {
  /// One struct each, so that compilers know its counts apart and add up what follows in a row.
  struct alignas(64) Cell {
    std::uint64_t counts[k_operation_count];
  };

  Cell cells[k_cell_count];
  std::size_t cell;                         ///< the present one
  std::size_t first_of_ray;                 ///< the first one of the present kind of ray
  const LegListener* listener;              ///< to legs, if there is one
  std::uint64_t rays;                       ///< a bit for each since the reset
  std::uint64_t rays_entered;               ///< a bit for each since a listener has cleared them
  std::uint64_t entered[k_ray_kind_count];  ///< a bit for each function of a ray since the reset
  ExtentCounts extents[k_extent_kind_count];
  std::uint32_t ray;                                        ///< the present kind
  int root_steps_end;                                       ///< more than any of them took
  std::uint32_t intersection_roots[k_root_step_limit + 1];  ///< by steps, those of intersections
  RayKind shadow_ray;               ///< towards the light that was asked last
  RayKind waiting[k_waiting_rays];  ///< by place on the stack of rays

  std::uint64_t& place(Operation operation) {
    return cells[cell].counts[static_cast<std::size_t>(operation)];
  }

  void enter_function(std::uint32_t function) {
    cell = first_of_ray + function;
    entered[ray] |= std::uint64_t{1} << function;
  }

  /// In the function as it is.
  void enter_ray(std::uint32_t kind) {
    const std::size_t function = cell - first_of_ray;
    ray = kind;
    rays |= std::uint64_t{1} << kind;
    rays_entered |= std::uint64_t{1} << kind;
    first_of_ray = std::size_t{kind} * k_function_count;
    cell = first_of_ray + function;
    entered[kind] |= std::uint64_t{1} << function;
  }

  /// Whether a ray is being intersected with a primitive.
  [[nodiscard]] bool is_in_intersection() const {
    return cell - first_of_ray >= std::size_t{k_fixed_function_count};
  }

  /// Calls `visit(cell, counts)` for each cell that may have been counted in.
  template <class Visit>
  void for_each_cell(Visit visit) {
    // Neither the kind of ray nor the cell with which all begins is ever entered.
    for_each_bit(rays | 1U, [&](std::uint32_t kind) {
      for_each_bit(entered[kind] | static_cast<std::uint64_t>(kind == 0),
                   [&](std::uint32_t function) {
                     const std::uint32_t visited = kind * k_function_count + function;
                     visit(visited, cells[visited].counts);
                   });
    });
  }

  [[nodiscard]] LongWork sum() {
    const Cell* visited[k_cell_count];
    int end = 0;
    for_each_cell([&](std::uint32_t place, const std::uint64_t* /*counts*/) {
      visited[end++] = cells + place;
    });
    constexpr int k_in_registers = 12;
    static_assert(k_operation_count % k_in_registers == 0);
    LongWork work;  // set below, as are the counts of `narrowed`: zeroing takes as long
    for (int first = 0; first < k_operation_count; first += k_in_registers) {
      std::uint64_t sums[k_in_registers]{};
      for (int i = 0; i < end; ++i) {
        for (int j = 0; j < k_in_registers; ++j) {
          sums[j] += visited[i]->counts[first + j];
        }
      }
      for (int j = 0; j < k_in_registers; ++j) {
        work.counts[first + j] = sums[j];
      }
    }
    return work;
  }

  /// Outside of every function.
  void reset() {
    for_each_cell([](std::uint32_t /*visited*/, std::uint64_t* cell_counts) {
      for (int i = 0; i < k_operation_count; ++i) {
        cell_counts[i] = 0;
      }
    });
    for_each_bit(rays | 1U, [this](std::uint32_t kind) { entered[kind] = 0; });
    rays = 0;
    for (ExtentCounts& extent : extents) {
      extent = {};
    }
    for (; root_steps_end > 0; --root_steps_end) {
      intersection_roots[root_steps_end - 1] = 0;
    }
  }
};

static_assert(k_function_count <= 64);

/// One meter per thread, because operators have no place for a parameter; read it with
/// `counted_work`.
inline thread_local CountedMeter counted_meter{};

/// Takes operations on zero operands out of their general class.
template <class Counts>
void set_general_apart(Counts& counts) {
  counts[Operation::add] -= counts[Operation::add_zero];
  counts[Operation::subtract] -= counts[Operation::subtract_zero];
  counts[Operation::multiply] -= counts[Operation::multiply_zero];
  counts[Operation::divide] -= counts[Operation::divide_zero];
}

/// `counts` with operations on zero operands taken out of their general class.
template <class Counts>
Counts general_apart(Counts counts) {
  set_general_apart(counts);
  return counts;
}

/// Says which count does not fit 32 bits.
[[noreturn]] inline void throw_too_many(const LongWork& counts) {
  int i = 0;
  while (counts.counts[i] <= std::numeric_limits<std::uint32_t>::max()) {
    ++i;
  }
  throw std::overflow_error(
      std::string("a pixel, or what precedes all pixels, takes ") +
      std::to_string(counts.counts[i]) + " of `" + k_operation_names[i] +
      "`, and 4294967295 can be counted; a smaller ray_tree.depth, fewer samples, lights or "
      "bodies take less");
}

/// The counts in 32 bits. Throws std::overflow_error when one does not fit.
inline Work narrowed(const LongWork& counts) {
  Work work;
  std::uint64_t bits = 0;
  for (int i = 0; i < k_operation_count; ++i) {
    work.counts[i] = static_cast<std::uint32_t>(counts.counts[i]);
    bits |= counts.counts[i];
  }
  if (bits > std::numeric_limits<std::uint32_t>::max()) {
    throw_too_many(counts);
  }
  return work;
}

}  // namespace maquette::firmware
