#include "firmware/fresnel.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

/// Fresnel's two amplitudes for dielectrics, as in any textbook.
struct Amplitudes {
  double perpendicular;
  double parallel;
};

Amplitudes amplitudes(double cosine, double index) {
  const double sine = std::sqrt(1 - cosine * cosine);
  const double bent = std::sqrt(1 - sine * sine / (index * index));
  return {(cosine - index * bent) / (cosine + index * bent),
          (index * cosine - bent) / (index * cosine + bent)};
}

double critical_cosine(double index) { return index < 1 ? std::sqrt(1 - index * index) : 0; }

TEST_CASE("Dielectrics reflect the mean of both polarisations") {
  trial::Random random(501);
  for (int i = 0; i < 5000; ++i) {
    const double index = random.magnitude(0.4, 2.5);
    const double cosine = random.uniform(critical_cosine(index) + 1e-9, 1);
    const Amplitudes exact = amplitudes(cosine, index);
    const double mean =
        (exact.perpendicular * exact.perpendicular + exact.parallel * exact.parallel) / 2;
    REQUIRE(dielectric_border(cosine, index).reflected == Approx(mean).margin(1e-9));
  }
}

TEMPLATE_TEST_CASE("Dielectrics have their closed values", "", float, double) {
  using Real = TestType;
  const double rounding = 20 * static_cast<double>(ulps<Real>(1));
  for (const double n : {1.1, 1.33, 1.5, 2.4, 0.8}) {
    const Real index = constant<Real>(n);
    const double frontal = std::pow((n - 1) / (n + 1), 2);
    CHECK(static_cast<double>(dielectric_border(Real(1), index).reflected) ==
          Approx(frontal).epsilon(100 * rounding));
    CHECK(static_cast<double>(dielectric_border(Real(1e-6), index).reflected) ==
          Approx(1).margin(1e-4));
    // At Brewster's angle only the perpendicular part is left.
    const double brewster = std::cos(std::atan(n));
    const double half = std::pow((n * n - 1) / (n * n + 1), 2) / 2;
    CHECK(static_cast<double>(dielectric_border(constant<Real>(brewster), index).reflected) ==
          Approx(half).epsilon(100 * rounding));
  }
  CHECK(dielectric_border(Real(0.5), Real(1)).reflected == Real(0));
}

TEST_CASE("Reflection is total beyond the critical angle, and nowhere else") {
  for (const double index : {0.5, 1 / 1.5, 0.9}) {
    const double critical = critical_cosine(index);
    const DielectricBorder<double> beyond = dielectric_border(critical * (1 - 1e-9), index);
    CHECK(beyond.reflected == 1);
    CHECK(beyond.transmitted_cosine == 0);
    CHECK(dielectric_border(critical * (1 + 1e-9), index).reflected < 1);
    CHECK(dielectric_border(critical * (1 + 1e-9), index).reflected > 0.99);
  }
}

TEST_CASE("A border reflects the same from both sides at angles of Snell's law") {
  trial::Random random(502);
  for (int i = 0; i < 5000; ++i) {
    const double index = random.uniform(1.01, 3);
    const double cosine = random.uniform(1e-3, 1);
    const DielectricBorder<double> entering = dielectric_border(cosine, index);
    const double bent = entering.transmitted_cosine / index;
    // Snell: sin = n sin'.
    REQUIRE(1 - cosine * cosine == Approx(index * index * (1 - bent * bent)).margin(1e-12));
    const DielectricBorder<double> leaving = dielectric_border(bent, 1 / index);
    REQUIRE(leaving.reflected == Approx(entering.reflected).margin(1e-10));
    REQUIRE(leaving.transmitted_cosine * index == Approx(cosine).margin(1e-10));
  }
}

TEST_CASE("Conductors have their closed values") {
  trial::Random random(503);
  for (int i = 0; i < 5000; ++i) {
    const double n = random.magnitude(0.05, 5);
    const double k = random.magnitude(0.01, 9);
    const double frontal = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
    REQUIRE(conductor_reflection(1.0, n, k) == Approx(frontal).epsilon(1e-9));
    REQUIRE(conductor_reflection(0.0, n, k) == Approx(1));
  }
}

TEST_CASE("A conductor without extinction is a dielectric") {
  trial::Random random(504);
  for (int i = 0; i < 5000; ++i) {
    const double index = random.magnitude(0.4, 3);
    const double cosine = random.uniform(critical_cosine(index) + 1e-6, 1);
    REQUIRE(conductor_reflection(cosine, index, 0.0) ==
            Approx(dielectric_border(cosine, index).reflected).margin(1e-9));
  }
}

TEMPLATE_TEST_CASE("No border reflects less than nothing or more than all", "", float, double) {
  using Real = TestType;
  trial::Random random(505);
  const Real most = Real(1) + ulps<Real>(8);
  for (int i = 0; i < 20000; ++i) {
    const Real cosine =
        constant<Real>(random.coin() ? random.uniform() : random.magnitude(1e-8, 1));
    const Real n = constant<Real>(random.magnitude(0.05, 20));
    const Real k = constant<Real>(random.magnitude(0.001, 20));
    const Real dielectric = dielectric_border(cosine, n).reflected;
    const Real conductor = conductor_reflection(cosine, n, k);
    REQUIRE((dielectric >= 0 && dielectric <= most));
    REQUIRE((conductor >= 0 && conductor <= most));
  }
}

}  // namespace
}  // namespace maquette::firmware
