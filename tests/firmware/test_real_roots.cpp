#include "firmware/real_roots.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "firmware/counted.hpp"
#include "tests/firmware/exact_roots.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

using trial::ExactCase;
using trial::Random;

const std::string k_table =
    std::string(MAQUETTE_PROJECT_DIRECTORY) + "/tests/firmware/exact_roots.txt";

/// A root may be off by so many spacings times its conditioning.
constexpr long double k_allowed_spacings = 2;

template <class Real>
Polynomial<Real> as(const Polynomial<double>& polynomial) {
  Polynomial<Real> result;
  result.degree = polynomial.degree;
  for (int i = 0; i <= polynomial.degree; ++i) {
    result.terms[i] = static_cast<Real>(polynomial.terms[i]);
  }
  return result;
}

/// The exact roots that the convention for ends leaves: an end counts where its neighbourhood is
/// negative.
std::vector<long double> expected_roots(const ExactCase& exact) {
  const Polynomial<double>& p = exact.polynomial;
  const auto is_zero = [](double term) { return sign_of(term) == 0; };
  const double* first = std::find_if_not(p.terms, p.terms + p.degree + 1, is_zero);
  if (first == p.terms + p.degree + 1) {
    return {};
  }
  const double* last = p.terms + p.degree;
  while (is_zero(*last)) {
    --last;
  }
  std::vector<long double> expected;
  if (first != p.terms && *first < 0) {
    expected.push_back(0);
  }
  for (const long double root : exact.roots) {
    if (root > 0 && root < 1) {
      expected.push_back(root);
    }
  }
  if (last != p.terms + p.degree && *last < 0) {
    expected.push_back(1);
  }
  return expected;
}

/// What is known of a family after all its polynomials.
struct Tally {
  int polynomials = 0;
  int roots = 0;
  int missed = 0;    ///< well-conditioned roots without a root found within their conditioning
  int spurious = 0;  ///< roots found where the value is not within rounding
  int parity_errors = 0;
  int steps = 0;
};

/// How far rounding of the terms may move a simple root: spacings times conditioning.
long double uncertainty(const trial::Neighbourhood& at, long double root, long double spacing) {
  return spacing * (at.magnitude / std::fabs(at.slope) + root);
}

bool is_well_conditioned(const trial::Neighbourhood& at, long double uncertain) {
  return uncertain * k_allowed_spacings * std::fabs(at.curvature) < 0.1L * std::fabs(at.slope);
}

template <class Real>
void add_case(const ExactCase& exact, Tally& tally) {
  const auto spacing = static_cast<long double>(std::numeric_limits<Real>::epsilon());
  const RealRoots<Real> found = roots_of(as<Real>(exact.polynomial));
  const std::vector<long double> expected = expected_roots(exact);
  ++tally.polynomials;
  tally.roots += found.count;
  tally.steps += found.steps;
  tally.parity_errors += (found.count - static_cast<int>(expected.size())) % 2 != 0 ? 1 : 0;
  for (const long double root : expected) {
    const trial::Neighbourhood at = trial::neighbourhood(exact.polynomial, root);
    const long double uncertain = uncertainty(at, root, spacing);
    if (is_well_conditioned(at, uncertain)) {
      long double error = 2;
      for (int i = 0; i < found.count; ++i) {
        error = std::fmin(error, std::fabs(static_cast<long double>(found.at[i]) - root));
      }
      tally.missed += error > k_allowed_spacings * uncertain ? 1 : 0;
    }
  }
  for (int i = 0; i < found.count; ++i) {
    const auto root = static_cast<long double>(found.at[i]);
    const trial::Neighbourhood at = trial::neighbourhood(exact.polynomial, root);
    const long double rounding = spacing * (at.magnitude + std::fabs(at.slope) * root);
    tally.spurious += std::fabs(at.value) > k_allowed_spacings * rounding ? 1 : 0;
  }
}

template <class Real>
std::map<std::string, Tally> tallies() {
  std::map<std::string, Tally> families;
  for (const ExactCase& exact : trial::exact_cases(k_table, std::numeric_limits<Real>::digits)) {
    add_case<Real>(exact, families[exact.family]);
  }
  return families;
}

TEMPLATE_TEST_CASE("No family of polynomials loses, invents or misplaces a root", "", float,
                   double) {
  const std::map<std::string, Tally> families = tallies<TestType>();
  CHECK(families.size() == 14);
  for (const auto& [family, tally] : families) {
    CAPTURE(family);
    CHECK(tally.missed == 0);
    CHECK(tally.spurious == 0);
    CHECK(tally.parity_errors == 0);
  }
}

TEMPLATE_TEST_CASE("A root of an ordinary ray takes three to five steps", "", float, double) {
  std::map<std::string, Tally> families = tallies<TestType>();
  for (const char* family : {"ordinary", "sextic", "flat_ray", "grazing", "cluster", "random"}) {
    const Tally& tally = families[family];
    const double steps_per_root = static_cast<double>(tally.steps) / tally.roots;
    CAPTURE(family, steps_per_root);
    CHECK(steps_per_root > 2);
    CHECK(steps_per_root < 5);
  }
}

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
  for (const ExactCase& exact : trial::exact_cases(k_table, 24)) {
    const RealRoots<float> plain = roots_of(as<float>(exact.polynomial));
    Polynomial<Counted> polynomial{};
    polynomial.degree = exact.polynomial.degree;
    for (int i = 0; i <= polynomial.degree; ++i) {
      polynomial.terms[i] = static_cast<float>(exact.polynomial.terms[i]);
    }
    const RealRoots<Counted> counted = roots_of(polynomial);
    REQUIRE(counted.count == plain.count);
    for (int i = 0; i < plain.count; ++i) {
      REQUIRE(counted.at[i].value == plain.at[i]);
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
