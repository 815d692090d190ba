#pragma once

#include <cstddef>

#include "firmware/polynomials/real_roots.hpp"
#include "firmware/vector.hpp"

/// A polynomial f(x, y, z) of total degree n: n, then the coefficients of x^i y^j z^k in the order
/// in which Horner's rule takes them, zeros too: k from n down to 0, for each k the j from n - k
/// down, for each j the i from n - k - j down.
namespace maquette::firmware::algebraic {

constexpr std::ptrdiff_t parameter_count(int degree) {
  return 1 + (degree + 1) * (degree + 2) * (degree + 3) / 6;
}

/// Where the coefficient of x^i y^j z^k stands.
constexpr std::ptrdiff_t parameter_index(int degree, int i, int j, int k) {
  const int below_z = degree - k;
  const int below_y = below_z - j;
  return 1 + below_z * (below_z + 1) * (below_z + 2) / 6 + below_y * (below_y + 1) / 2 +
         (below_y - i);
}

/// Horner's rule, nested for the three variables, in any arithmetic: of values that begin as
/// `zero`, are multiplied by a variable and added to a coefficient or to another value.
template <class Real, class Arithmetic>
typename Arithmetic::Value horner(const Real* parameters, const Arithmetic& arithmetic) {
  using Value = typename Arithmetic::Value;
  const int degree = to_integer(parameters[0]);
  const Real* coefficient = parameters + 1;
  Value sum = arithmetic.zero();
  for (int k = degree; k >= 0; --k) {
    Value plane = arithmetic.zero();
    for (int j = degree - k; j >= 0; --j) {
      Value row = arithmetic.zero();
      for (int i = degree - k - j; i >= 0; --i) {
        charge<Real>(Operation::load);
        arithmetic.multiply(row, 0);
        arithmetic.add(row, *coefficient++);
      }
      arithmetic.multiply(plane, 1);
      arithmetic.add(plane, row);
    }
    arithmetic.multiply(sum, 2);
    arithmetic.add(sum, plane);
  }
  return sum;
}

/// Polynomials in u along the chord from `low` (u = 0) to `high` (u = 1). The degree of a value is
/// one less than the number of its multiplications, so that values added are of one degree.
template <class Real>
struct ChordArithmetic {
  struct Value {
    Polynomial<Real> polynomial;
    bool is_zero;  ///< the terms are not written
  };

  Vector<Real> low;
  Vector<Real> high;

  [[nodiscard]] Value zero() const {
    Value value;
    value.polynomial.degree = -1;
    value.is_zero = true;
    return value;
  }

  /// By the coordinate low (1 - u) + high u.
  void multiply(Value& value, int axis) const {
    const int degree = ++value.polynomial.degree;
    if (value.is_zero) {
      return;
    }
    Real* terms = value.polynomial.terms;
    terms[degree] = terms[degree - 1] * high[axis];
    for (int i = degree - 1; i > 0; --i) {
      terms[i] = terms[i] * low[axis] + terms[i - 1] * high[axis];
    }
    terms[0] = terms[0] * low[axis];
  }

  void add(Value& value, Real coefficient) const {
    if (sign_of(coefficient) == 0) {
      return;
    }
    const Real* binomials = bernstein::k_binomials<Real>[value.polynomial.degree];
    add_terms(value, [&](int i) { return coefficient * binomials[i]; });
  }

  void add(Value& value, const Value& other) const {
    if (!other.is_zero) {
      add_terms(value, [&](int i) { return other.polynomial.terms[i]; });
    }
  }

 private:
  template <class Terms>
  static void add_terms(Value& value, const Terms& terms) {
    for (int i = 0; i <= value.polynomial.degree; ++i) {
      Real& term = value.polynomial.terms[i];
      term = value.is_zero ? terms(i) : term + terms(i);
    }
    value.is_zero = false;
  }
};

/// f along a chord, in Bernstein form: rounding moves it by what rounding the coefficients moves f.
template <class Real>
Polynomial<Real> along_chord(const Real* parameters, const Vector<Real>& low,
                             const Vector<Real>& high) {
  auto value = horner(parameters, ChordArithmetic<Real>{low, high});
  if (value.is_zero) {
    value.polynomial.degree = 0;
    value.polynomial.terms[0] = constant<Real>(0);
  }
  return value.polynomial;
}

/// f and its gradient at a point.
template <class Real>
struct Jet {
  Real value;
  Vector<Real> gradient;
};

template <class Real>
struct JetArithmetic {
  using Value = Jet<Real>;

  Vector<Real> point;

  [[nodiscard]] Value zero() const {
    const Real nothing = constant<Real>(0);
    return {nothing, {nothing, nothing, nothing}};
  }
  void multiply(Value& jet, int axis) const {
    jet.gradient *= point[axis];
    jet.gradient[axis] += jet.value;
    jet.value *= point[axis];
  }
  void add(Value& jet, Real coefficient) const { jet.value += coefficient; }
  void add(Value& jet, const Value& other) const {
    jet.value += other.value;
    jet.gradient += other.gradient;
  }
};

template <class Real>
Jet<Real> jet_at(const Real* parameters, const Vector<Real>& point) {
  return horner(parameters, JetArithmetic<Real>{point});
}

}  // namespace maquette::firmware::algebraic
