#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "firmware/arithmetic/counted_meter.hpp"

namespace maquette::sim {

/// What many pixels, or the preprocessing, took by kind of ray and function, what extents told, and
/// how many steps the roots of intersections took.
struct FunctionWork {
  using Counts = std::array<std::uint64_t, firmware::k_operation_count>;

  /// A row for each kind of ray as far as there are some, at least the first.
  std::vector<Counts> cells = std::vector<Counts>(firmware::k_function_count);
  std::array<firmware::ExtentCounts, firmware::k_extent_kind_count> extents{};
  std::array<std::uint64_t, firmware::k_root_step_limit + 1> intersection_roots{};  ///< by steps

  [[nodiscard]] static std::size_t cell(std::size_t ray, std::size_t function) {
    return ray * firmware::k_function_count + function;
  }

  [[nodiscard]] std::size_t ray_kinds() const { return cells.size() / firmware::k_function_count; }

  /// Makes rows for so many kinds of rays where there are fewer.
  void reach(std::size_t ray_kinds);

  /// Adds what the meter of this thread has counted since its last reset.
  void add(firmware::CountedMeter& meter);
  void add(const FunctionWork& other);
};

/// The numbers that are not zero, with their places: to be kept in a file.
std::vector<std::uint64_t> numbers_of(const FunctionWork& work);

/// From such numbers; false when they are none.
bool read_numbers(const std::vector<std::uint64_t>& numbers, FunctionWork& work);

/// Operations and events of one pixel by function, of any kind of ray; as many as can be counted
/// where there are more.
using FunctionCounts = std::array<std::uint32_t, firmware::k_function_count>;

/// Those that the meter of this thread has counted since its last reset.
FunctionCounts function_counts(firmware::CountedMeter& meter);

/// Of a whole frame.
struct FrameWork {
  FunctionWork preprocessing;  ///< of each board
  FunctionWork pixels;
};

}  // namespace maquette::sim
