#include "firmware/arithmetic/elementary.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

/// Distance of a result from the exact value in ulps of the exact value.
template <class Real>
double error_in_ulps(Real result, long double exact) {
  const long double unit = std::fabs(exact) * static_cast<long double>(ulps<Real>(1));
  return static_cast<double>(std::fabs(static_cast<long double>(result) - exact) / unit);
}

/// Largest error of a function over random arguments.
template <class Real, class Function, class Exact>
double largest_error(double low, double high, Function function, Exact exact) {
  trial::Random random(401);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Real x = static_cast<Real>(random.uniform(low, high));
    worst = std::fmax(worst, error_in_ulps(function(x), exact(static_cast<long double>(x))));
  }
  return worst;
}

TEMPLATE_TEST_CASE("The exponential agrees with the exact one", "", float, double) {
  using Real = TestType;
  const auto function = [](Real x) { return exponential(x); };
  const auto exact = [](long double x) { return std::exp(x); };
  CHECK(largest_error<Real>(-1, 1, function, exact) < 3);
  CHECK(largest_error<Real>(-87, 87, function, exact) < 3);
  CHECK(exponential(Real(0)) == Real(1));
  CHECK(exponential(Real(-1e9)) == Real(0));
  CHECK(exponential(Real(1e9)) == std::numeric_limits<Real>::max());
}

TEMPLATE_TEST_CASE("The logarithm agrees with the exact one", "", float, double) {
  using Real = TestType;
  const auto function = [](Real x) { return logarithm(x); };
  const auto exact = [](long double x) { return std::log(x); };
  CHECK(largest_error<Real>(1e-6, 0.7, function, exact) < 4);
  CHECK(largest_error<Real>(0.7, 1.4, function, exact) < 4);
  CHECK(largest_error<Real>(1.4, 1e6, function, exact) < 4);
  CHECK(logarithm(Real(1)) == Real(0));
}

TEMPLATE_TEST_CASE("A power is as good as the product of exponent and logarithm", "", float,
                   double) {
  using Real = TestType;
  trial::Random random(402);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Real base = static_cast<Real>(random.uniform(0.01, 1));
    const Real exponent = static_cast<Real>(random.magnitude(0.5, 500));
    const long double product =
        std::fabs(static_cast<long double>(exponent) * std::log(static_cast<long double>(base)));
    if (product < 80) {
      const long double exact = std::pow(static_cast<long double>(base), exponent);
      const double allowed = 4 + 4 * static_cast<double>(product);
      worst = std::fmax(worst, error_in_ulps(power(base, exponent), exact) / allowed);
    }
  }
  CHECK(worst < 1);
  CHECK(power(Real(0), Real(3)) == Real(0));
  CHECK(power(Real(1), Real(300)) == Real(1));
}

TEMPLATE_TEST_CASE("The arc cosine agrees with the exact one", "", float, double) {
  using Real = TestType;
  const auto function = [](Real x) { return arc_cosine(x); };
  const auto exact = [](long double x) { return std::acos(x); };
  CHECK(largest_error<Real>(0, 0.999, function, exact) < 5);
  CHECK(largest_error<Real>(0.999, 0.9999999, function, exact) < 5);
  CHECK(arc_cosine(Real(1)) == Real(0));
  CHECK(arc_cosine(Real(1.5)) == Real(0));
}

TEMPLATE_TEST_CASE("Sine and cosine agree with the exact ones", "", float, double) {
  using Real = TestType;
  const auto sine_of = [](Real x) { return sine(x); };
  const auto cosine_of = [](Real x) { return cosine(x); };
  const auto exact_sine = [](long double x) { return std::sin(x); };
  const auto exact_cosine = [](long double x) { return std::cos(x); };
  CHECK(largest_error<Real>(-0.7853, 0.7853, sine_of, exact_sine) < 3);
  CHECK(largest_error<Real>(-0.7853, 0.7853, cosine_of, exact_cosine) < 3);
  CHECK(largest_error<Real>(0.7853, 1.5707, sine_of, exact_sine) < 8);
}

}  // namespace
}  // namespace maquette::firmware
