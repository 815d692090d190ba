#pragma once

#include <cstdint>
#include <vector>

namespace maquette::sim {

/// Shares in [0, 1) for `samples` points along each of `axes` axes: every axis has exactly one
/// point in each of `samples` equal parts, in an order of its own (McKay, Beckman and Conover
/// 1979). The same seed gives the same shares with any compiler: std::mt19937_64 with mappings of
/// its own. Result: [axis][point].
[[nodiscard]] std::vector<std::vector<double>> latin_hypercube(int axes, int samples,
                                                               std::uint64_t seed);

}  // namespace maquette::sim
