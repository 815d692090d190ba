#include "sim/database/algebraic_frame.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/primitives/algebraic_polynomial.hpp"

namespace maquette::sim {

LocalFrame algebraic_frame(const AlgebraicShape& shape) {
  const Vector3 half = shape.size / 2.0;
  int degree = 0;
  for (const AlgebraicTerm& term : shape.terms) {
    const auto& [i, j, k] = term.exponents;
    degree = std::max(degree, i + j + k);
  }
  LocalFrame frame;
  frame.kind = firmware::PrimitiveKind::algebraic;
  std::vector<double>& parameters = frame.parameters;
  parameters.resize(static_cast<std::size_t>(firmware::algebraic::parameter_count(degree)));
  for (const AlgebraicTerm& term : shape.terms) {
    const auto& [i, j, k] = term.exponents;
    const auto index =
        static_cast<std::size_t>(firmware::algebraic::parameter_index(degree, i, j, k));
    parameters[index] +=
        term.coefficient * std::pow(half.x, i) * std::pow(half.y, j) * std::pow(half.z, k);
  }
  double largest = 0;
  for (const double coefficient : parameters) {
    largest = std::max(largest, std::abs(coefficient));
  }
  for (double& coefficient : parameters) {
    coefficient /= largest;
  }
  parameters[0] = degree;
  frame.to_object = {half.x, 0, 0, 0, half.y, 0, 0, 0, half.z, 0, 0, 0};
  return frame;
}

}  // namespace maquette::sim
