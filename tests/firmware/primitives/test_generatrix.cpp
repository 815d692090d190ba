#include "firmware/primitives/generatrix.hpp"

#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::revolution {
namespace {

using trial::Random;

std::vector<double> random_control(Random& random, int points) {
  std::vector<double> control;
  for (int i = 0; i < points; ++i) {
    control.insert(control.end(), {random.uniform(0, 1), random.uniform(0, 1)});
  }
  return control;
}

std::vector<double> parameters_of(const std::vector<double>& control, bool is_open) {
  const int points = static_cast<int>(control.size()) / 2;
  std::vector<double> parameters(
      static_cast<std::size_t>(parameter_count(section_count(points, is_open))));
  write_parameters(control.data(), points, is_open, parameters.data());
  return parameters;
}

/// A coordinate of section `i` of the spline by the basis functions of a uniform cubic B-spline.
double spline_value(const std::vector<double>& control, std::size_t i, std::size_t k, double u) {
  const std::size_t count = control.size() / 2;
  const double v = 1 - u;
  const double basis[4] = {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6,
                           (-3 * u * u * u + 3 * u * u + 3 * u + 1) / 6, u * u * u / 6};
  double sum = 0;
  for (std::size_t j = 0; j < 4; ++j) {
    sum += basis[j] * control[2 * ((i + j) % count) + k];
  }
  return sum;
}

TEST_CASE("The Bezier sections are the B-spline") {
  Random random(1901);
  for (int i = 0; i < 300; ++i) {
    const bool is_open = random.coin();
    const std::vector<double> control = random_control(random, 4 + random.below(15));
    const std::vector<double> parameters = parameters_of(control, is_open);
    const Generatrix<double> curve = generatrix(parameters.data());
    REQUIRE(curve.is_open == is_open);
    for (int section = 0; section < curve.sections; ++section) {
      const double u = random.uniform();
      const CurvePoint<double> point = curve_point(curve.section(section), u);
      const auto number = static_cast<std::size_t>(section);
      REQUIRE(point.x == Approx(spline_value(control, number, 0, u)));
      REQUIRE(point.y == Approx(spline_value(control, number, 1, u)));
    }
    if (!is_open) {
      REQUIRE(curve.points[0] == curve.section(curve.sections)[0]);
      REQUIRE(curve.points[1] == curve.section(curve.sections)[1]);
    }
  }
}

/// Checks the extents of a node and of those below it.
void check_extents(const Generatrix<double>& curve, int node, int first, int sections) {
  const RingExtent<double> extent = curve.extent(node);
  for (int i = 0; i <= 3 * sections; ++i) {
    const double* point = curve.section(first) + i * k_point_reals;
    REQUIRE(point[0] >= extent.low_r);
    REQUIRE(point[0] <= extent.high_r);
    REQUIRE(point[1] >= extent.low_z);
    REQUIRE(point[1] <= extent.high_z);
  }
  if (sections > 1) {
    check_extents(curve, node + 1, first, sections / 2);
    check_extents(curve, node + 2 * (sections / 2), first + sections / 2, sections - sections / 2);
  }
}

TEST_CASE("Every node's extent holds the control points below it") {
  Random random(1902);
  for (int points = 4; points < k_section_limit; ++points) {
    const std::vector<double> parameters =
        parameters_of(random_control(random, points), random.coin());
    const Generatrix<double> curve = generatrix(parameters.data());
    check_extents(curve, 0, 0, curve.sections);
  }
}

TEST_CASE("Counted numbers meet a solid where floats do and are charged for it") {
  Random random(1903);
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> parameters = parameters_of(random_control(random, 8), true);
    const std::vector<float> plain(parameters.begin(), parameters.end());
    const std::vector<Counted> counted(plain.begin(), plain.end());
    const Vector<float> origin(random.in_cube() - Vector<double>(3, 0, 0));
    const Vector<float> direction(Vector<double>(1, 0, 0) + random.in_cube(0.2));
    Hit<float> hits[k_hit_limit];
    Hit<Counted> counted_hits[k_hit_limit];
    reset_counted_work();
    const int count = intersect<float>({origin, direction}, plain.data(), hits);
    const int counted_count =
        intersect<Counted>({Vector<Counted>(origin.x, origin.y, origin.z),
                            Vector<Counted>(direction.x, direction.y, direction.z)},
                           counted.data(), counted_hits);
    REQUIRE(count == counted_count);
    for (int k = 0; k < count; ++k) {
      REQUIRE(hits[k].distance == counted_hits[k].distance.value);
    }
    REQUIRE(counted_work()[Operation::multiply] > (count > 0 ? 100U : 10U));
  }
}

}  // namespace
}  // namespace maquette::firmware::revolution
