#include "firmware/polynomials/bernstein.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

using trial::Random;

ControlPolygon<double> random_polygon(Random& random, int degree) {
  ControlPolygon<double> polygon{degree, {}};
  for (int i = 0; i <= degree; ++i) {
    polygon.ordinates[i] = random.uniform(-1, 1);
  }
  return polygon;
}

/// By the definition of the form.
double defined_value(const Polynomial<double>& polynomial, double u) {
  double sum = 0;
  for (int i = 0; i <= polynomial.degree; ++i) {
    sum += polynomial.terms[i] * std::pow(u, i) * std::pow(1 - u, polynomial.degree - i);
  }
  return sum;
}

TEST_CASE("Values, halves, derivatives and products are those of the polynomial") {
  Random random(1601);
  for (int i = 0; i < 5000; ++i) {
    const int degree = random.below(5);
    const ControlPolygon<double> polygon = random_polygon(random, degree);
    const Polynomial<double> polynomial = polynomial_of(polygon);
    const double u = random.uniform();
    const auto close_to = [](double exact) { return Approx(exact).epsilon(0).margin(1e-13); };
    REQUIRE(value_at(polygon, u) == close_to(defined_value(polynomial, u)));
    REQUIRE(value_at(control_polygon_of(polynomial), u) == close_to(value_at(polygon, u)));
    ControlPolygon<double> lower{};
    ControlPolygon<double> upper{};
    bisect(polygon, lower, upper);
    REQUIRE(value_at(lower, u) == close_to(value_at(polygon, u / 2)));
    REQUIRE(value_at(upper, u) == close_to(value_at(polygon, 0.5 + u / 2)));
    const double step = 1e-6;
    const double secant = value_at(polygon, u + step) - value_at(polygon, u - step);
    REQUIRE(value_at(derivative(polygon), u) ==
            Approx(secant / (2 * step)).epsilon(0).margin(1e-8));
    const Polynomial<double> other = polynomial_of(random_polygon(random, random.below(5)));
    REQUIRE(defined_value(product(polynomial, other), u) ==
            close_to(defined_value(polynomial, u) * defined_value(other, u)));
  }
}

TEMPLATE_TEST_CASE("Halves share an ordinate and have no more sign changes than the whole", "",
                   float, double) {
  Random random(1602);
  for (int i = 0; i < 5000; ++i) {
    ControlPolygon<TestType> polygon{random.below(k_degree_limit + 1), {}};
    for (int k = 0; k <= polygon.degree; ++k) {
      const double size = random.magnitude(1e-12, 1);
      polygon.ordinates[k] = static_cast<TestType>(random.coin() ? size : -size);
    }
    ControlPolygon<TestType> lower{};
    ControlPolygon<TestType> upper{};
    for (int depth = 0; depth < 30; ++depth) {
      bisect(polygon, lower, upper);
      REQUIRE(lower.ordinates[polygon.degree] == upper.ordinates[0]);
      REQUIRE(sign_changes(polynomial_of(lower)) + sign_changes(polynomial_of(upper)) <=
              sign_changes(polynomial_of(polygon)));
      polygon = random.coin() ? lower : upper;
    }
  }
}

TEST_CASE("Zeros do not count as changes of sign") {
  CHECK(sign_changes(Polynomial<float>{4, {1, 0, -1, 0, -2}}) == 1);
  CHECK(sign_changes(Polynomial<float>{4, {0, 0, 0, 0, 0}}) == 0);
  CHECK(sign_changes(Polynomial<float>{4, {0, -1, 0, 1, -1}}) == 2);
}

}  // namespace
}  // namespace maquette::firmware
