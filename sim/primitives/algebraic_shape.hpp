#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace maquette::sim {

/// coefficient x^i y^j z^k.
struct AlgebraicTerm {
  std::array<int, 3> exponents{};
  double coefficient = 0;
};

/// Where the sum of the terms is not above zero in a box that is centred on the origin.
struct AlgebraicShape {
  std::vector<AlgebraicTerm> terms;
  glm::dvec3 size{1, 1, 1};  ///< edge lengths of the box
};

}  // namespace maquette::sim
