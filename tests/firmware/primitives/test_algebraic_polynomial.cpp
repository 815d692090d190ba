#include "firmware/primitives/algebraic_polynomial.hpp"

#include "firmware/polynomials/bernstein.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/primitives/algebraic_solids.hpp"

namespace maquette::firmware::algebraic {
namespace {

using trial::Random;

TEST_CASE("A coefficient has a place of its own") {
  for (int degree = 1; degree <= k_degree_limit; ++degree) {
    std::vector<std::ptrdiff_t> places;
    for (int i = 0; i <= degree; ++i) {
      for (int j = 0; i + j <= degree; ++j) {
        for (int k = 0; i + j + k <= degree; ++k) {
          places.push_back(parameter_index(degree, i, j, k));
        }
      }
    }
    std::sort(places.begin(), places.end());
    REQUIRE(static_cast<std::ptrdiff_t>(places.size()) == parameter_count(degree) - 1);
    for (std::size_t i = 0; i < places.size(); ++i) {
      REQUIRE(places[i] == static_cast<std::ptrdiff_t>(i) + 1);
    }
  }
}

TEMPLATE_TEST_CASE("The polynomial of a chord has the surface's value at every point of it", "",
                   float, double) {
  using Real = TestType;
  Random random(2101);
  for (int i = 0; i < 500; ++i) {
    const Solid solid = random_solid(random);
    const Vector<Real> low(random.in_cube());
    const Vector<Real> high(random.in_cube());
    const Polynomial<Real> along = along_chord(parameters_of<Real>(solid), low, high);
    double sum = 0;
    for (const Term& term : solid.terms) {
      sum += std::fabs(term.coefficient);
    }
    for (int k = 0; k <= 10; ++k) {
      const Vector<double> p =
          Vector<double>(low) * (1 - k / 10.0) + Vector<double>(high) * (k / 10.0);
      const Real value = firmware::value_at(control_polygon_of(along), static_cast<Real>(k / 10.0));
      CAPTURE(i, k, along.degree, sum);
      REQUIRE(std::fabs(static_cast<double>(value) - value_at(solid, p)) <=
              static_cast<double>(ulps<Real>(8)) * sum);
    }
  }
}

TEST_CASE("The gradient is the change of the value") {
  Random random(2102);
  for (int i = 0; i < 500; ++i) {
    const Solid solid = random_solid(random);
    const Vector<double> p = random.in_cube();
    const Jet<double> jet = jet_at(solid.parameters.data(), p);
    REQUIRE(jet.value == Approx(value_at(solid, p)).margin(1e-12));
    REQUIRE(glm::length(jet.gradient - gradient_at(solid, p)) < 1e-6);
  }
}

}  // namespace
}  // namespace maquette::firmware::algebraic
