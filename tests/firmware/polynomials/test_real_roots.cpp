#include "firmware/polynomials/real_roots.hpp"

#include <algorithm>
#include <cmath>

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

using trial::Random;

/// A product of factors with the given roots and of others without a root in [0, 1].
Polynomial<double> with_roots(const std::vector<double>& roots, int degree, Random& random) {
  Polynomial<double> result{0, {random.coin() ? 1.0 : -1.0}};
  for (const double root : roots) {
    result = product(result, Polynomial<double>{1, {-root, 1 - root}});
  }
  while (result.degree < degree) {
    result = product(result, Polynomial<double>{1, {random.uniform(0.1), random.uniform(0.1)}});
  }
  return result;
}

TEST_CASE("The roots that a polynomial of any degree is made of come back in order") {
  Random random(1701);
  for (int i = 0; i < 4000; ++i) {
    const int degree = 1 + random.below(k_degree_limit);
    const int count = random.below(degree + 1);
    std::vector<double> roots;
    roots.reserve(static_cast<std::size_t>(count));
    for (int k = 0; k < count; ++k) {
      roots.push_back((k + random.uniform(0.2, 0.8)) / count);
    }
    const RealRoots<double> found = roots_of(with_roots(roots, degree, random));
    CAPTURE(i, degree, count);
    REQUIRE(found.count == count);
    for (std::size_t k = 0; k < roots.size(); ++k) {
      REQUIRE(found.at[k] == Approx(roots[k]).epsilon(0).margin(1e-9));
    }
  }
}

template <class Real>
int count_on(const ControlPolygon<Real>& polygon) {
  return roots_of(polynomial_of(polygon)).count;
}

TEMPLATE_TEST_CASE("Of two intervals with a root at their joint exactly one finds it", "", float,
                   double) {
  Random random(1702);
  for (int i = 0; i < 4000; ++i) {
    // Integers small enough that nothing rounds, crossing zero at the joint with any multiplicity.
    ControlPolygon<TestType> left{6, {}};
    ControlPolygon<TestType> right{6, {}};
    const int zeros = 1 + random.below(5);
    const double sign = random.coin() ? 1 : -1;
    for (int k = 0; k <= 6; ++k) {
      const double size = k < zeros ? 0 : 1 + random.below(9);
      left.ordinates[6 - k] = static_cast<TestType>(-sign * size);
      right.ordinates[k] = static_cast<TestType>(sign * size);
    }
    CAPTURE(i, zeros, sign);
    REQUIRE(count_on(left) + count_on(right) == 1);
    // Touching zero from either side is no crossing, or two.
    for (TestType& ordinate : right.ordinates) {
      ordinate = -ordinate;
    }
    REQUIRE((count_on(left) + count_on(right)) % 2 == 0);
  }
}

TEST_CASE("Halves together have the roots of the whole, a root at the middle once") {
  Random random(1703);
  for (int i = 0; i < 2000; ++i) {
    std::vector<double> roots = {random.uniform(0.05, 0.4), 0.5, random.uniform(0.6, 0.95)};
    Polynomial<double> whole{0, {1}};
    for (double& root : roots) {
      root = std::floor(root * 64) / 64;
      whole = product(whole, Polynomial<double>{1, {-root, 1 - root}});
    }
    ControlPolygon<double> lower{};
    ControlPolygon<double> upper{};
    bisect(control_polygon_of(whole), lower, upper);
    const int in_halves = count_on(lower) + count_on(upper);
    CAPTURE(i, roots[0], roots[2]);
    REQUIRE(roots_of(whole).count == 3);
    REQUIRE(in_halves % 2 == 1);
    REQUIRE(in_halves == 3);
  }
}

TEMPLATE_TEST_CASE("Roots do not depend on the scale of the polynomial", "", float, double) {
  Random random(1704);
  for (int i = 0; i < 2000; ++i) {
    Polynomial<TestType> one{6, {}};
    Polynomial<TestType> other{6, {}};
    const int exponent = random.below(101) - 50;
    for (int k = 0; k <= 6; ++k) {
      one.terms[k] = static_cast<TestType>(random.uniform(-1, 1));
      other.terms[k] = std::ldexp(one.terms[k], exponent);
    }
    const RealRoots<TestType> of_one = roots_of(one);
    const RealRoots<TestType> of_other = roots_of(other);
    REQUIRE(of_one.count == of_other.count);
    REQUIRE(std::equal(of_one.at, of_one.at + of_one.count, of_other.at));
  }
}

TEST_CASE("A wider tolerance costs fewer steps, moves no root by more, and loses none") {
  Random random(1706);
  long last_steps = std::numeric_limits<long>::max();
  for (const double tolerance : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3}) {
    Random same = random;
    long steps = 0;
    for (int i = 0; i < 3000; ++i) {
      const std::vector<double> roots = {same.uniform(0.02, 0.3), same.uniform(0.35, 0.65),
                                         same.uniform(0.7, 0.98)};
      const Polynomial<double> polynomial = with_roots(roots, 6, same);
      const RealRoots<double> found = roots_of(polynomial, tolerance);
      REQUIRE(found.count == 3);
      for (int k = 0; k < 3; ++k) {
        CAPTURE(i, k, tolerance);
        CHECK(std::abs(found.at[k] - roots[static_cast<std::size_t>(k)]) <= tolerance + 1e-12);
      }
      steps += found.steps;
    }
    CHECK(steps < last_steps);
    last_steps = steps;
  }
}

TEMPLATE_TEST_CASE("Extreme terms give roots in [0, 1], few and in order, or none", "", float,
                   double) {
  using Limits = std::numeric_limits<TestType>;
  const TestType values[] = {0,
                             1,
                             -1,
                             Limits::denorm_min(),
                             -Limits::denorm_min(),
                             Limits::min(),
                             Limits::max(),
                             -Limits::max(),
                             Limits::infinity(),
                             -Limits::infinity(),
                             Limits::quiet_NaN()};
  Random random(1705);
  for (int i = 0; i < 20000; ++i) {
    Polynomial<TestType> polynomial{random.below(k_degree_limit + 1), {}};
    for (int k = 0; k <= polynomial.degree; ++k) {
      polynomial.terms[k] = values[random.below(11)];
    }
    const RealRoots<TestType> found = roots_of(polynomial);
    CAPTURE(i);
    REQUIRE(found.count <= polynomial.degree);
    for (int k = 0; k < found.count; ++k) {
      REQUIRE(found.at[k] >= (k == 0 ? TestType(0) : found.at[k - 1]));
      REQUIRE(found.at[k] <= TestType(1));
    }
  }
}

TEST_CASE("Counted numbers find the same roots as floats") {
  Random random(1706);
  for (int i = 0; i < 2000; ++i) {
    Polynomial<float> polynomial{1 + random.below(k_degree_limit), {}};
    Polynomial<Counted> counting{polynomial.degree, {}};
    for (int k = 0; k <= polynomial.degree; ++k) {
      polynomial.terms[k] = static_cast<float>(random.uniform(-1, 1));
      counting.terms[k] = polynomial.terms[k];
    }
    const RealRoots<float> plain = roots_of(polynomial);
    const RealRoots<Counted> counted = roots_of(counting);
    REQUIRE(counted.count == plain.count);
    for (int k = 0; k < plain.count; ++k) {
      REQUIRE(counted.at[k].value == plain.at[k]);
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
