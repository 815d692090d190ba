#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "firmware/primitives/algebraic.hpp"
#include "sim/primitives/local_frame.hpp"

namespace maquette::sim {

/// coefficient x^i y^j z^k.
struct AlgebraicTerm {
  std::array<int, 3> exponents{};
  double coefficient = 0;
};

/// Where the sum of the terms is not above zero in a box that is centred on the origin.
struct AlgebraicShape {
  using Kind = firmware::algebraic::Kind;

  std::vector<AlgebraicTerm> terms;
  glm::dvec3 size{1, 1, 1};  ///< edge lengths of the box
};

/// An algebraic surface in the firmware's terms: its box is the cube from -1 to 1, its largest
/// coefficient of magnitude 1. The shape must be a checked one.
[[nodiscard]] LocalFrame frame_of(const AlgebraicShape& shape);

}  // namespace maquette::sim
