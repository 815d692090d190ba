#include "sim/primitives/algebraic.hpp"

#include <cmath>

#include "firmware/primitives/algebraic.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"
#include "tests/sim/description_files.hpp"

namespace maquette::sim {
namespace {

using firmware::trial::Random;

AlgebraicShape random_shape(Random& random) {
  AlgebraicShape shape;
  shape.size = {random.magnitude(0.01, 100), random.magnitude(0.01, 100),
                random.magnitude(0.01, 100)};
  shape.terms = {{{1, 0, 0}, 1}};
  for (int i = random.below(12); i >= 0; --i) {
    AlgebraicTerm term;
    int left = firmware::k_degree_limit;
    for (int& exponent : term.exponents) {
      exponent = random.below(left + 1);
      left -= exponent;
    }
    term.coefficient = random.uniform(-2, 2);
    shape.terms.push_back(term);
  }
  return shape;
}

double value_of(const AlgebraicShape& shape, const Vector3& p) {
  double sum = 0;
  for (const AlgebraicTerm& term : shape.terms) {
    const auto& [i, j, k] = term.exponents;
    sum += term.coefficient * std::pow(p.x, i) * std::pow(p.y, j) * std::pow(p.z, k);
  }
  return sum;
}

}  // namespace

TEST_CASE("The polynomial keeps its values in the local frame, up to one factor") {
  Random random(31);
  for (int i = 0; i < 300; ++i) {
    const AlgebraicShape shape = random_shape(random);
    const LocalFrame frame = frame_of(shape);
    const auto value = [&](const Vector3& local) {
      return firmware::algebraic::jet_at(frame.parameters.data(), local).value;
    };
    const auto expected = [&](const Vector3& local) {
      return value_of(shape, firmware::transform_point(frame.to_object, local));
    };
    const Vector3 first = random.in_cube();
    const double factor = expected(first) / value(first);
    CHECK(factor > 0);
    for (int k = 0; k < 10; ++k) {
      const Vector3 local = random.in_cube();
      CHECK(value(local) * factor ==
            Approx(expected(local)).epsilon(1e-6).margin(1e-9 * std::abs(factor)));
    }
    CHECK(frame.to_object[1].y == shape.size.y / 2);
  }
}

TEST_CASE("The largest coefficient is 1") {
  Random random(32);
  for (int i = 0; i < 300; ++i) {
    const LocalFrame frame = frame_of(random_shape(random));
    double largest = 0;
    for (std::size_t k = 1; k < frame.parameters.size(); ++k) {
      largest = std::fmax(largest, std::fabs(frame.parameters[k]));
    }
    CHECK(largest == 1);
  }
}

TEST_CASE("Terms that make no surface are refused with the reason") {
  const auto error = [](const std::string& algebraic) {
    return error_of(
        "view: {eye: [4, -6, 3], target: [0, 0, 0], field_of_view: 35 deg}\n"
        "surfaces: {red: {diffuse: 0.5}}\n"
        "object:\n  surface: red\n  algebraic:\n    " +
        algebraic + "\n");
  };
  const auto check = [&error](const std::string& algebraic, const std::string& expected) {
    const std::string message = error(algebraic);
    INFO(message);
    CHECK(message.find("scene.yaml:6:") == 0);
    CHECK(message.find(expected) != std::string::npos);
  };
  CHECK(error("{size: 2, terms: [[8, 0, 0, 1], [0, 0, 0, -1]]}").empty());
  check("size: 2", "`terms` is missing");
  check("terms: [[8, 0, 0, 1]]", "`size` is missing");
  check("{size: 0, terms: [[8, 0, 0, 1]]}", "size: ");
  check("{size: 2, terms: 3}", "a list of terms is allowed");
  check("{size: 2, terms: []}", "the polynomial is constant");
  check("{size: 2, terms: [[0, 0, 0, 1]]}", "the polynomial is constant");
  check("{size: 2, terms: [[1, 0, 0, 1], [1, 0, 0, -1], [0, 1, 0, 0]]}",
        "the polynomial is constant");
  check("{size: 2, terms: [[1, 0, 1]]}", "three exponents and a coefficient");
  check("{size: 2, terms: [[9, 0, 0, 1]]}", "terms: ");
  check("{size: 2, terms: [[-1, 0, 0, 1]]}", "terms: ");
  check("{size: 2, terms: [[1.5, 0, 0, 1]]}", "terms: ");
  check("{size: 2, terms: [[4, 3, 2, 1]]}", "a term of degree 9 stands here; up to 8");
  check("{size: 2, terms: [[1, 0, 0, .nan]]}", "terms: ");
  check("{size: 2, terms: [[1, 0, 0, .inf]]}", "terms: ");
  check("{size: 2, terms: [[1, 0, 0, 1 mm]]}", "terms: ");
}

}  // namespace maquette::sim
