#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/primitives/algebraic_polynomial.hpp"
#include "tests/firmware/primitives/parameters_of.hpp"
#include "tests/firmware/random_cases.hpp"

/// Algebraic solids whose value is known term by term.
namespace maquette::firmware::algebraic {

struct Term {
  int i;
  int j;
  int k;
  double coefficient;
};

/// A polynomial of either number type, and as its terms.
struct Solid {
  std::vector<Term> terms;
  std::vector<double> parameters;
  std::vector<float> as_float;
};

/// Scaled so that the largest coefficient is 1; terms of equal exponents add up.
inline Solid solid_of(const std::vector<Term>& terms) {
  int degree = 0;
  for (const Term& term : terms) {
    degree = std::max(degree, term.i + term.j + term.k);
  }
  Solid solid;
  solid.parameters.assign(static_cast<std::size_t>(parameter_count(degree)), 0);
  for (const Term& term : terms) {
    const std::ptrdiff_t index = parameter_index(degree, term.i, term.j, term.k);
    solid.parameters[static_cast<std::size_t>(index)] += term.coefficient;
  }
  double largest = 0;
  for (const double coefficient : solid.parameters) {
    largest = std::fmax(largest, std::fabs(coefficient));
  }
  for (double& coefficient : solid.parameters) {
    coefficient /= largest;
  }
  for (Term term : terms) {
    term.coefficient /= largest;
    solid.terms.push_back(term);
  }
  solid.parameters[0] = degree;
  solid.as_float.assign(solid.parameters.begin(), solid.parameters.end());
  return solid;
}

/// f term by term.
inline double value_at(const Solid& solid, const Vector<double>& p) {
  double sum = 0;
  for (const Term& term : solid.terms) {
    sum += term.coefficient * std::pow(p.x, term.i) * std::pow(p.y, term.j) * std::pow(p.z, term.k);
  }
  return sum;
}

/// By differences.
inline Vector<double> gradient_at(const Solid& solid, const Vector<double>& p) {
  const double step = 1e-5;
  Vector<double> gradient;
  for (int axis = 0; axis < 3; ++axis) {
    Vector<double> aside(0, 0, 0);
    aside[axis] = step;
    gradient[axis] = (value_at(solid, p + aside) - value_at(solid, p - aside)) / (2 * step);
  }
  return gradient;
}

/// Of any degree, with all terms or few.
inline Solid random_solid(trial::Random& random) {
  const int degree = 1 + random.below(k_degree_limit);
  const bool is_dense = random.coin();
  std::vector<Term> terms{{degree, 0, 0, random.uniform(-1, 1)}, {0, 0, 0, random.uniform(-1, 0)}};
  for (int i = 0; i <= degree; ++i) {
    for (int j = 0; i + j <= degree; ++j) {
      for (int k = 0; i + j + k <= degree; ++k) {
        if (is_dense || random.below(5) == 0) {
          terms.push_back({i, j, k, random.uniform(-1, 1)});
        }
      }
    }
  }
  return solid_of(terms);
}

}  // namespace maquette::firmware::algebraic
