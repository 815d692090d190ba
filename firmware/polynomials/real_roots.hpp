#pragma once

#include <limits>

#include "firmware/polynomials/laguerre.hpp"

/// Where a polynomial changes its sign on [0, 1]: isolation by Descartes' rule of signs and
/// bisection (Collins and Loos 1982), then Laguerre's method (paper, section IV.2.4).
///
/// An end at which the polynomial is exactly zero counts as positive. So the roots found are an
/// even number where both ends are of one sign and an odd number where they are not, and of two
/// intervals with a common end that is a root exactly one finds it.
namespace maquette::firmware {

template <class Real>
struct RealRoots {
  Real at[k_degree_limit];  ///< in ascending order
  int count;
  int limit;       ///< the degree of the polynomial
  int steps;       ///< of Laguerre's method, all roots together
  Real tolerance;  ///< of each root, relative to its distance from the nearer end of its interval
};

namespace real_roots {

template <class Real>
RealRoots<Real> none_of(int degree, Real tolerance) {
  RealRoots<Real> roots;
  roots.count = 0;
  roots.limit = degree;
  roots.steps = 0;
  roots.tolerance = tolerance;
  return roots;
}

/// The part of [0, 1] that an isolation looks at.
template <class Real>
struct Span {
  Real low;
  Real width;
  int bisections;
};

/// Bisections down to 2^-limit, below which everything is one with 0.
template <class Real>
inline constexpr int k_bisection_limit = 2 * std::numeric_limits<Real>::digits;

/// Roots closer than the ulp of the numbers at their place are not told apart.
template <class Real>
bool is_indivisible(const Span<Real>& span) {
  return span.bisections >= k_bisection_limit<Real> || span.width <= span.low * ulps<Real>(1);
}

/// Where rounding makes more roots than the degree allows, two of them are left out.
template <class Real>
void add(RealRoots<Real>& roots, Real at) {
  if (roots.count < roots.limit) {
    roots.at[roots.count++] = at;
  } else {
    --roots.count;
  }
}

/// Ends that are zero, taken out as factors u and 1 - u, and whether the sign changes there.
template <class Real>
struct Deflated {
  Polynomial<Real> rest;  ///< of degree -1 when all terms are zero
  bool root_at_low;
  bool root_at_high;
};

template <class Real>
Deflated<Real> deflated(const Polynomial<Real>& polynomial) {
  int first = 0;
  int last = polynomial.degree;
  while (first <= last && sign_of(polynomial.terms[first]) == 0) {
    ++first;
  }
  while (last >= first && sign_of(polynomial.terms[last]) == 0) {
    --last;
  }
  Deflated<Real> result;
  result.rest.degree = last - first;
  for (int i = first; i <= last; ++i) {
    result.rest.terms[i - first] = polynomial.terms[i];
  }
  result.root_at_low = first <= last && first > 0 && sign_of(polynomial.terms[first]) < 0;
  result.root_at_high =
      first <= last && last < polynomial.degree && sign_of(polynomial.terms[last]) < 0;
  return result;
}

/// Adds the root inside the span of a polynomial whose ends are not zero, when the signs of the
/// ends tell that there is one.
template <class Real>
void add_between_ends(const Polynomial<Real>& polynomial, const Span<Real>& span,
                      RealRoots<Real>& roots) {
  if (sign_of(polynomial.terms[0]) * sign_of(polynomial.terms[polynomial.degree]) < 0) {
    const int before = roots.steps;
    add(roots, span.low + span.width * refine_root(polynomial, roots.tolerance, roots.steps));
    RootSteps<Real>::note(roots.steps - before);
  }
}

/// Adds the roots in the span if they need no bisection; returns whether that is so.
template <class Real>
bool add_isolated(const Polynomial<Real>& polynomial, const Span<Real>& span,
                  RealRoots<Real>& roots) {
  if (sign_of(polynomial.terms[0]) != 0 && sign_of(polynomial.terms[polynomial.degree]) != 0) {
    if (sign_changes(polynomial) > 1 && !is_indivisible(span)) {
      return false;
    }
    add_between_ends(polynomial, span, roots);
    return true;
  }
  const Deflated<Real> inner = deflated(polynomial);
  if (inner.rest.degree < 0) {
    return true;
  }
  if (sign_changes(inner.rest) > 1 && !is_indivisible(span)) {
    return false;
  }
  if (inner.root_at_low) {
    add(roots, span.low);
  }
  add_between_ends(inner.rest, span, roots);
  if (inner.root_at_high) {
    add(roots, span.low + span.width);
  }
  return true;
}

/// Adds the roots of a curve of which `polynomial_of` makes a polynomial and which `bisect` halves.
template <class Real, class Curve>
void isolate(const Curve& curve, const Span<Real>& span, RealRoots<Real>& roots) {
  charge<Real>(Operation::isolation);
  if (add_isolated(polynomial_of(curve), span, roots)) {
    return;
  }
  Curve lower;
  Curve upper;
  bisect(curve, lower, upper);
  const Real half = span.width * constant<Real>(0.5);
  isolate(lower, Span<Real>{span.low, half, span.bisections + 1}, roots);
  isolate(upper, Span<Real>{span.low + half, half, span.bisections + 1}, roots);
}

}  // namespace real_roots

/// The roots in [0, 1] of the polynomial, of the given degree, of a curve that is bisected in a
/// form of its own.
template <class Real, class Curve>
RealRoots<Real> roots_of_curve(const Curve& curve, int degree, Real tolerance = ulps<Real>(1)) {
  RealRoots<Real> roots = real_roots::none_of<Real>(degree, tolerance);
  real_roots::isolate(curve, real_roots::Span<Real>{constant<Real>(0), constant<Real>(1), 0},
                      roots);
  return roots;
}

/// The roots in [0, 1] of a polynomial. Pairs that rounding does not separate may be missing,
/// always both of them. The zero polynomial has none.
template <class Real>
RealRoots<Real> roots_of(const Polynomial<Real>& polynomial, Real tolerance = ulps<Real>(1)) {
  RealRoots<Real> roots = real_roots::none_of<Real>(polynomial.degree, tolerance);
  const real_roots::Span<Real> whole{constant<Real>(0), constant<Real>(1), 0};
  if (!real_roots::add_isolated(polynomial, whole, roots)) {
    real_roots::isolate(control_polygon_of(polynomial), whole, roots);
  }
  return roots;
}

}  // namespace maquette::firmware
