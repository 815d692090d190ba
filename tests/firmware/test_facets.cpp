#include "firmware/facets.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/facet_surface.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

constexpr FacetDistribution k_distributions[] = {FacetDistribution::cosine_power,
                                                 FacetDistribution::gaussian,
                                                 FacetDistribution::trowbridge_reitz};
constexpr double k_degree = elementary::k_pi / 180;

TEST_CASE("Every distribution falls to one half of its peak at the half angle") {
  for (const FacetDistribution distribution : k_distributions) {
    for (const double half_angle_deg : {1.0, 5.0, 20.0, 40.0, 60.0}) {
      const Surface<double> surface = trial::facet_surface(distribution, half_angle_deg * k_degree);
      const double peak = facet_distribution(surface, 1.0);
      const double half = facet_distribution(surface, std::cos(half_angle_deg * k_degree));
      CAPTURE(static_cast<int>(distribution), half_angle_deg);
      CHECK(half / peak == Approx(0.5).epsilon(1e-9));
    }
  }
}

TEST_CASE("Distributions fall with the angle and are never negative") {
  for (const FacetDistribution distribution : k_distributions) {
    const Surface<double> surface = trial::facet_surface(distribution, 20 * k_degree);
    double last = facet_distribution(surface, 1.0);
    for (int step = 1; step <= 100; ++step) {
      const double value = facet_distribution(surface, 1 - 0.01 * step);
      REQUIRE(value <= last);
      REQUIRE(value >= 0);
      last = value;
    }
  }
}

TEMPLATE_TEST_CASE("Single and double precision agree on every distribution", "", float) {
  trial::Random random(901);
  for (const FacetDistribution distribution : k_distributions) {
    const Surface<double> surface = trial::facet_surface(distribution, 10 * k_degree);
    const auto rounded = trial::rounded<float>(surface);
    for (int i = 0; i < 1000; ++i) {
      const auto cosine = static_cast<float>(random.uniform(0.9, 1));
      const double exact = facet_distribution(surface, static_cast<double>(cosine));
      REQUIRE(static_cast<double>(facet_distribution(rounded, cosine)) ==
              Approx(exact).epsilon(1e-4));
    }
  }
}

TEST_CASE("The attenuation lies between 0 and 1 and treats light and view alike") {
  trial::Random random(902);
  const Vector<double> normal(0, 0, 1);
  for (int i = 0; i < 20000; ++i) {
    const Vector<double> view = random.direction_around(normal, random.uniform(1e-4, 1));
    const Vector<double> light = random.direction_around(normal, random.uniform(1e-4, 1));
    const Vector<double> half = glm::normalize(view + light);
    const double v_h = glm::dot(view, half);
    const double one_way = facet_attenuation(half.z, view.z, light.z, v_h);
    const double other_way = facet_attenuation(half.z, light.z, view.z, glm::dot(light, half));
    REQUIRE(one_way >= 0);
    REQUIRE(one_way <= 1);
    REQUIRE(other_way == Approx(one_way).epsilon(1e-9));
  }
  CHECK(facet_attenuation(1.0, 1.0, 1.0, 1.0) == 1);
}

}  // namespace
}  // namespace maquette::firmware
