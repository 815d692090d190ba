#pragma once

#include "firmware/arithmetic/root_steps.hpp"
#include "firmware/polynomials/bernstein.hpp"

/// One root refined inside an interval that holds it (paper, section IV.2.4).
namespace maquette::firmware {

namespace laguerre {

/// Steps after which the middle of the bracket is taken as it is: each halves the bracket at least
/// where Laguerre's steps do not help.
inline constexpr int k_step_limit = k_root_step_limit;

/// A polynomial in s = u / (1 - u), of which Bernstein terms are the plain coefficients, with two
/// derivatives. Laguerre's method is the same in s and in u: its steps do not depend on a
/// projective change of variable.
template <class Real>
struct Jet {
  Real value;
  Real slope;
  Real half_curvature;
};

/// Horner's rule.
template <class Real>
Jet<Real> jet_at(const Polynomial<Real>& polynomial, Real s) {
  const Real zero = constant<Real>(0);
  Jet<Real> jet{polynomial.terms[polynomial.degree], zero, zero};
  for (int i = polynomial.degree - 1; i >= 0; --i) {
    jet.half_curvature = jet.half_curvature * s + jet.slope;
    jet.slope = jet.slope * s + jet.value;
    jet.value = jet.value * s + polynomial.terms[i];
  }
  return jet;
}

/// Whether a value at s can not be told from zero: within the rounding of Horner's rule.
template <class Real>
bool is_rounding(const Polynomial<Real>& polynomial, Real s, Real value) {
  Real sum = absolute(polynomial.terms[polynomial.degree]);
  for (int i = polynomial.degree - 1; i >= 0; --i) {
    sum = sum * s + absolute(polynomial.terms[i]);
  }
  return absolute(value) <= sum * from_integer<Real>(polynomial.degree) * ulps<Real>(1);
}

/// Laguerre's step towards a root at which the polynomial changes in the sense of `rising`. Not a
/// number or far off where there is none; the caller looks whether it stays in the bracket.
template <class Real>
Real step_from(const Jet<Real>& jet, int degree, bool rising) {
  const Real zero = constant<Real>(0);
  const Real one = constant<Real>(1);
  charge<Real>(Operation::load);
  const Real n = bernstein::k_binomials<Real>[degree][1];
  const Real inverse = one / jet.slope;
  const Real newton = jet.value * inverse;
  const Real bend = newton * (jet.half_curvature + jet.half_curvature) * inverse;
  const Real root = square_root(larger(zero, (n - one) * (n - one - n * bend)));
  const bool along = (jet.slope > zero) == rising;
  return n * newton / (along ? one + root : one - root);
}

/// The root in (0, 1] of a polynomial in s that has one there; `terms[0]` and the value at 1 are
/// not of the same sign. Ends when the error expected is at most `tolerance` times the root. Adds
/// its steps to `steps`.
template <class Real>
Real refined(const Polynomial<Real>& polynomial, Real tolerance, int& steps) {
  const bool rising = polynomial.terms[0] < constant<Real>(0);
  Real low = constant<Real>(0);
  Real high = constant<Real>(1);
  Real s = high;
  Real last_move = high;
  for (int step = 0; step < k_step_limit; ++step) {
    charge<Real>(Operation::root_step);
    ++steps;
    const Jet<Real> jet = jet_at(polynomial, s);
    const int sign = sign_of(jet.value);
    if (sign == 0) {
      return s;
    }
    ((sign < 0) == rising ? low : high) = s;
    Real next = s - step_from(jet, polynomial.degree, rising);
    if (!(low < next && next < high)) {
      if (is_rounding(polynomial, s, jet.value)) {
        return s;
      }
      next = (low + high) * constant<Real>(0.5);
    }
    // The method is of third order near the root: the next move is smaller than this one by the
    // square of what this one is than the last. Near is also nearer than 0, where s ends.
    const Real move = absolute(next - s);
    last_move = smaller(last_move, s);
    if (move * move * move <= tolerance * next * last_move * last_move) {
      return next;
    }
    last_move = move;
    s = next;
  }
  return s;
}

}  // namespace laguerre

/// The root in [0, 1] of a polynomial whose first and last terms are of opposite signs; one of
/// several where there are more. Laguerre's method from the middle, inside a bracket that every
/// step narrows, with bisection where a step would leave it, until the error expected is at most
/// `tolerance` times the distance to the nearer end. Adds its steps to `steps`.
template <class Real>
Real refine_root(const Polynomial<Real>& polynomial, Real tolerance, int& steps) {
  const Real one = constant<Real>(1);
  const int degree = polynomial.degree;
  charge<Real>(Operation::root);
  Real middle = polynomial.terms[0];
  for (int i = 1; i <= degree; ++i) {
    middle += polynomial.terms[i];
  }
  if (sign_of(middle) * sign_of(polynomial.terms[0]) <= 0) {
    const Real s = laguerre::refined(polynomial, tolerance, steps);
    return s / (one + s);
  }
  // The upper half: from its other end, s = (1 - u) / u.
  Polynomial<Real> reversed;
  reversed.degree = degree;
  for (int i = 0; i <= degree; ++i) {
    reversed.terms[i] = polynomial.terms[degree - i];
  }
  return one / (one + laguerre::refined(reversed, tolerance, steps));
}

}  // namespace maquette::firmware
