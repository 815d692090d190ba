#pragma once

#include "firmware/arithmetic/real.hpp"

/// Polynomials on [0, 1] in Bernstein form, the one whose roots suffer least from rounding (Farouki
/// and Rajan 1987).
namespace maquette::firmware {

inline constexpr int k_degree_limit = 8;

/// sum of terms[i] u^i (1 - u)^(degree - i): the binomial coefficients are in the terms, so that
/// products are convolutions and a factor u or 1 - u is taken out by leaving an end away.
template <class Real>
struct Polynomial {
  int degree;  ///< at most k_degree_limit
  Real terms[k_degree_limit + 1];
};

/// A polynomial by its Bernstein coefficients without the binomials: the ordinates of its control
/// polygon, which bisection needs.
template <class Real>
struct ControlPolygon {
  int degree;
  Real ordinates[k_degree_limit + 1];
};

namespace bernstein {

/// Rows of Pascal's triangle.
template <class Real>
inline constexpr Real k_binomials[k_degree_limit + 1][k_degree_limit + 1] = {
    {1},
    {1, 1},
    {1, 2, 1},
    {1, 3, 3, 1},
    {1, 4, 6, 4, 1},
    {1, 5, 10, 10, 5, 1},
    {1, 6, 15, 20, 15, 6, 1},
    {1, 7, 21, 35, 35, 21, 7, 1},
    {1, 8, 28, 56, 70, 56, 28, 8, 1}};

}  // namespace bernstein

template <class Real>
Polynomial<Real> polynomial_of(const ControlPolygon<Real>& polygon) {
  Polynomial<Real> polynomial;
  polynomial.degree = polygon.degree;
  for (int i = 0; i <= polygon.degree; ++i) {
    charge<Real>(Operation::load);
    polynomial.terms[i] = polygon.ordinates[i] * bernstein::k_binomials<Real>[polygon.degree][i];
  }
  return polynomial;
}

template <class Real>
ControlPolygon<Real> control_polygon_of(const Polynomial<Real>& polynomial) {
  ControlPolygon<Real> polygon;
  polygon.degree = polynomial.degree;
  for (int i = 0; i <= polynomial.degree; ++i) {
    charge<Real>(Operation::load);
    polygon.ordinates[i] = polynomial.terms[i] / bernstein::k_binomials<Real>[polynomial.degree][i];
  }
  return polygon;
}

/// Value at u in [0, 1] (de Casteljau).
template <class Real>
Real value_at(const ControlPolygon<Real>& polygon, Real u) {
  const Real rest = constant<Real>(1) - u;
  ControlPolygon<Real> row = polygon;
  for (int last = polygon.degree; last > 0; --last) {
    for (int i = 0; i < last; ++i) {
      row.ordinates[i] = rest * row.ordinates[i] + u * row.ordinates[i + 1];
    }
  }
  return row.ordinates[0];
}

/// The derivative with respect to u.
template <class Real>
ControlPolygon<Real> derivative(const ControlPolygon<Real>& polygon) {
  ControlPolygon<Real> result;
  result.degree = polygon.degree > 0 ? polygon.degree - 1 : 0;
  result.ordinates[0] = constant<Real>(0);
  const Real degree = from_integer<Real>(polygon.degree);
  for (int i = 0; i < polygon.degree; ++i) {
    result.ordinates[i] = degree * (polygon.ordinates[i + 1] - polygon.ordinates[i]);
  }
  return result;
}

/// The halves over [0, 1/2] and [1/2, 1], each seen as [0, 1] (de Casteljau). A mean of two numbers
/// lies between them also when rounded, hence both halves together have no more sign changes than
/// the whole; the ordinate that they share is the same number.
template <class Real>
void bisect(const ControlPolygon<Real>& polygon, ControlPolygon<Real>& lower,
            ControlPolygon<Real>& upper) {
  const Real half = constant<Real>(0.5);
  const int degree = polygon.degree;
  upper = polygon;
  lower.degree = degree;
  lower.ordinates[0] = polygon.ordinates[0];
  for (int last = degree; last > 0; --last) {
    for (int i = 0; i < last; ++i) {
      upper.ordinates[i] = half * upper.ordinates[i] + half * upper.ordinates[i + 1];
    }
    lower.ordinates[degree - last + 1] = upper.ordinates[0];
  }
}

/// The product; the degrees together are at most k_degree_limit.
template <class Real>
Polynomial<Real> product(const Polynomial<Real>& a, const Polynomial<Real>& b) {
  Polynomial<Real> result;
  result.degree = a.degree + b.degree;
  for (int i = 0; i <= result.degree; ++i) {
    result.terms[i] = constant<Real>(0);
  }
  for (int i = 0; i <= a.degree; ++i) {
    for (int j = 0; j <= b.degree; ++j) {
      result.terms[i + j] += a.terms[i] * b.terms[j];
    }
  }
  return result;
}

/// -1, 0 or 1; 0 also for what is not a number.
template <class Real>
int sign_of(Real value) {
  const Real zero = constant<Real>(0);
  if (value < zero) {
    return -1;
  }
  return value > zero ? 1 : 0;
}

/// Changes of sign along the terms, zeros left out. Descartes' rule: the roots inside (0, 1),
/// counted with their multiplicities, are as many or fewer by an even number.
template <class Real>
int sign_changes(const Polynomial<Real>& polynomial) {
  int changes = 0;
  int last = 0;
  for (int i = 0; i <= polynomial.degree; ++i) {
    const int sign = sign_of(polynomial.terms[i]);
    changes += sign * last < 0 ? 1 : 0;
    last = sign != 0 ? sign : last;
  }
  return changes;
}

}  // namespace maquette::firmware
