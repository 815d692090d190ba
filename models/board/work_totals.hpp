#pragma once

#include <array>
#include <cstdint>

#include "firmware/arithmetic/work.hpp"

namespace maquette::models {

/// Work and rays of many pixels; a frame's counts do not fit into 32 bits.
struct WorkTotals {
  std::array<std::uint64_t, firmware::k_operation_count> operations{};
  std::uint64_t primary = 0;
  std::uint64_t reflected = 0;
  std::uint64_t refracted = 0;
  std::uint64_t shadow = 0;

  void add(const firmware::Work& work) {
    for (std::size_t operation = 0; operation < operations.size(); ++operation) {
      operations[operation] += work.counts[operation];
    }
  }

  void add(const firmware::RayCounts& rays) {
    primary += rays.primary;
    reflected += rays.reflected;
    refracted += rays.refracted;
    shadow += rays.shadow;
  }

  void add(const WorkTotals& other) {
    for (std::size_t operation = 0; operation < operations.size(); ++operation) {
      operations[operation] += other.operations[operation];
    }
    primary += other.primary;
    reflected += other.reflected;
    refracted += other.refracted;
    shadow += other.shadow;
  }
};

}  // namespace maquette::models
