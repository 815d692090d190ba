#include "firmware/primitives/generatrix_conversion.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "firmware/arithmetic/counted.hpp"
#include "firmware/primitives/revolution.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/generatrices.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware::revolution {
namespace {

using trial::converted;
using trial::given_sections;
using trial::given_spline;
using trial::Random;

std::vector<double> random_control(Random& random, int points) {
  std::vector<double> control;
  for (int i = 0; i < points; ++i) {
    control.insert(control.end(), {random.uniform(0, 1), random.uniform(0, 1)});
  }
  return control;
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

/// The integral of r dz by chords.
double swept_by_chords(const Generatrix<double>& curve) {
  constexpr int k_chords = 200;
  double sum = 0;
  CurvePoint<double> last = curve_point(curve.section(0), 0.0);
  for (int i = 1; i <= curve.sections * k_chords; ++i) {
    const int section = std::min(i / k_chords, curve.sections - 1);
    const double u = static_cast<double>(i) / k_chords - section;
    const CurvePoint<double> point = curve_point(curve.section(section), u);
    sum += (point.x + last.x) / 2 * (point.y - last.y);
    last = point;
  }
  return sum;
}

TEST_CASE("The Bezier sections are the B-spline, turned so that the solid is on the left") {
  Random random(1901);
  int turned = 0;
  for (int i = 0; i < 300; ++i) {
    const bool is_open = random.coin();
    const std::vector<double> control = random_control(random, 4 + random.below(15));
    const std::vector<double> parameters = converted<double>(given_spline(control, is_open));
    const Generatrix<double> curve = generatrix(parameters.data());
    REQUIRE(curve.is_open == is_open);
    REQUIRE(swept_by_chords(curve) > -1e-4);
    const bool is_turned =
        curve_point(curve.points, 0.25).x != Approx(spline_value(control, 0, 0, 0.25));
    turned += is_turned ? 1 : 0;
    for (int section = 0; section < curve.sections; ++section) {
      const double u = random.uniform();
      const CurvePoint<double> point = curve_point(curve.section(section), u);
      const auto number =
          static_cast<std::size_t>(is_turned ? curve.sections - 1 - section : section);
      const double along = is_turned ? 1 - u : u;
      REQUIRE(point.x == Approx(spline_value(control, number, 0, along)));
      REQUIRE(point.y == Approx(spline_value(control, number, 1, along)));
    }
    if (!is_open) {
      REQUIRE(curve.points[0] == curve.section(curve.sections)[0]);
      REQUIRE(curve.points[1] == curve.section(curve.sections)[1]);
    }
  }
  CHECK(turned > 50);
  CHECK(turned < 250);
}

TEST_CASE("The area that a section sweeps is that of its chords") {
  Random random(1904);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> parameters =
        converted<double>(given_spline(random_control(random, 4), true));
    const Generatrix<double> curve = generatrix(parameters.data());
    CHECK(swept(curve.points) / 20 == Approx(swept_by_chords(curve)).margin(1e-4));
  }
}

TEST_CASE("Bezier points are taken as they are, or the other way round") {
  Random random(1905);
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> points = random_control(random, 3 * (1 + random.below(20)) + 1);
    const std::vector<double> given = given_sections(points, true);
    std::vector<double> parameters(
        static_cast<std::size_t>(parameter_count(static_cast<int>(points.size()) / 6)));
    CHECK(convert(given.data(), parameters.data()) == given.data() + given.size());
    std::vector<double> chain(parameters.end() - static_cast<std::ptrdiff_t>(points.size()),
                              parameters.end());
    if (chain != points) {
      for (std::size_t k = 0; k < chain.size() / 2; ++k) {
        REQUIRE(chain[2 * k] == points[points.size() - 2 - 2 * k]);
        REQUIRE(chain[2 * k + 1] == points[points.size() - 1 - 2 * k]);
      }
    }
  }
}

TEST_CASE("Boards convert to what the host does in double precision, within rounding") {
  Random random(1906);
  for (int i = 0; i < 300; ++i) {
    const bool is_open = random.coin();
    const std::vector<double> given =
        given_spline(random_control(random, 4 + random.below(60)), is_open);
    const std::vector<double> exact = converted<double>(given);
    const std::vector<float> plain = converted<float>(given);
    const std::vector<Counted> counted = converted<Counted>(given);
    REQUIRE(plain.size() == exact.size());
    for (std::size_t k = 0; k < exact.size(); ++k) {
      REQUIRE(std::fabs(static_cast<double>(plain[k]) - exact[k]) <=
              4 * static_cast<double>(ulps<float>(1)) * std::fmax(1, std::fabs(exact[k])));
      REQUIRE(plain[k] == counted[k].value);
    }
  }
}

/// Checks the extents of a node and of those below it.
template <class Real>
void check_extents(const Generatrix<Real>& curve, int node, int first, int sections) {
  const RingExtent<Real> extent = curve.extent(node);
  for (int i = 0; i <= 3 * sections; ++i) {
    const Real* point = curve.section(first) + i * k_point_reals;
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

TEMPLATE_TEST_CASE("Every node's extent holds the control points below it, and the curve", "",
                   float, double) {
  using Real = TestType;
  Random random(1902);
  for (int points = 4; points < 80; ++points) {
    const std::vector<Real> parameters =
        converted<Real>(given_spline(random_control(random, points), random.coin()));
    const Generatrix<Real> curve = generatrix(parameters.data());
    check_extents(curve, 0, 0, curve.sections);
    const RingExtent<Real> whole = curve.extent(0);
    for (int i = 0; i < curve.sections; ++i) {
      const CurvePoint<Real> point =
          curve_point(curve.section(i), static_cast<Real>(random.uniform()));
      CHECK(point.x >= whole.low_r - ulps<Real>(4));
      CHECK(point.x <= whole.high_r + ulps<Real>(4));
      CHECK(point.y >= whole.low_z - ulps<Real>(4));
      CHECK(point.y <= whole.high_z + ulps<Real>(4));
    }
  }
}

/// What conversion takes of an operation.
std::int64_t work_of(Operation operation, int sections, bool is_open) {
  std::vector<double> control;
  for (int i = 0; i < sections + (is_open ? 3 : 0); ++i) {
    const double angle = 6.283185307179586 * i / sections;
    control.insert(control.end(), {0.6 + 0.3 * std::cos(angle), 0.3 * std::sin(angle)});
  }
  reset_counted_work();
  converted<Counted>(given_spline(control, is_open));
  return counted_work()[operation];
}

TEST_CASE("The work of a conversion grows with the number of sections and no faster") {
  for (const Operation operation :
       {Operation::add, Operation::multiply, Operation::load, Operation::part}) {
    for (const bool is_open : {false, true}) {
      const std::int64_t few = work_of(operation, 16, is_open);
      const std::int64_t more = work_of(operation, 32, is_open);
      CAPTURE(static_cast<int>(operation), few, more);
      CHECK(more > few);
      CHECK(work_of(operation, 64, is_open) - more == 2 * (more - few));
    }
  }
}

TEST_CASE("Counted numbers meet a solid where floats do and are charged for it") {
  Random random(1903);
  for (int i = 0; i < 200; ++i) {
    const std::vector<double> given = given_spline(random_control(random, 8), true);
    const std::vector<float> plain = converted<float>(given);
    const std::vector<Counted> counted = converted<Counted>(given);
    const Vector<float> origin(random.in_cube() - Vector<double>(3, 0, 0));
    const Vector<float> direction(Vector<double>(1, 0, 0) + random.in_cube(0.2));
    Hit<float> hits[k_primitive_hit_limit];
    Hit<Counted> counted_hits[k_primitive_hit_limit];
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
