#include "firmware/facets/facet_table.hpp"

#include <cmath>
#include <set>
#include <string>

#include "tests/catch.hpp"
#include "tests/firmware/facet_surface.hpp"
#include "tests/firmware/random_cases.hpp"

/// Laws that every row of the table of distributions keeps.
namespace maquette::firmware {
namespace {

constexpr double k_degree = elementary::k_pi / 180;
/// What a scene allows.
constexpr double k_least_half_angle = 0.01 * k_degree;
constexpr double k_largest_half_angle = 89 * k_degree;

/// Calls `check` with a surface of each distribution and its half angle, for the limits of the half
/// angle and for angles between them, all magnitudes alike.
template <class Check>
void for_each_surface(unsigned seed, int angles, const Check& check) {
  trial::Random random(seed);
  for (const FacetKind facets : trial::facet_kinds()) {
    for (int i = 0; i < angles + 2; ++i) {
      const double between =
          std::exp(random.uniform(std::log(k_least_half_angle), std::log(k_largest_half_angle)));
      const double half_angle =
          i == 0 ? k_least_half_angle : (i == 1 ? k_largest_half_angle : between);
      CAPTURE(distribution_of(facets).name, half_angle / k_degree);
      check(trial::facet_surface(facets, half_angle), half_angle);
    }
  }
}

TEST_CASE("Distributions are told apart by their names and titles") {
  std::set<std::string> names;
  std::set<std::string> titles;
  for (const FacetDistribution& row : k_facet_distributions.rows) {
    CHECK(names.insert(row.name).second);
    CHECK(titles.insert(row.title).second);
  }
}

TEST_CASE("Every distribution is scaled to what a mirror reflects, whatever the half angle") {
  for_each_surface(903, 40, [](const Surface<double>& surface, double /*half_angle*/) {
    CHECK(trial::hemisphere_integral(surface) == Approx(elementary::k_pi / 4).epsilon(1e-4));
  });
}

TEST_CASE("Every distribution falls to one half of its peak at the half angle") {
  for_each_surface(904, 200, [](const Surface<double>& surface, double half_angle) {
    const double peak = facet_distribution(surface, 1.0);
    // The cosine of a small angle is known to rounding only.
    const double tolerance = 1e-9 + 1e-14 / (half_angle * half_angle);
    CHECK(facet_distribution(surface, std::cos(half_angle)) / peak ==
          Approx(0.5).epsilon(tolerance));
  });
}

TEST_CASE("Every distribution falls with the angle and is never negative") {
  for_each_surface(905, 20, [](const Surface<double>& surface, double /*half_angle*/) {
    double last = facet_distribution(surface, 1.0);
    for (int step = 1; step <= 1000; ++step) {
      const double value = facet_distribution(surface, 1 - 0.001 * step);
      REQUIRE(value <= last);
      REQUIRE(value >= 0);
      last = value;
    }
  });
}

TEST_CASE("Single and double precision agree on every distribution") {
  trial::Random random(901);
  for (const FacetKind facets : trial::facet_kinds()) {
    const Surface<double> surface = trial::facet_surface(facets, 10 * k_degree);
    const auto rounded = trial::rounded<float>(surface);
    for (int i = 0; i < 1000; ++i) {
      const auto cosine = static_cast<float>(random.uniform(0.9, 1));
      const double exact = facet_distribution(surface, static_cast<double>(cosine));
      REQUIRE(static_cast<double>(facet_distribution(rounded, cosine)) ==
              Approx(exact).epsilon(1e-4));
    }
  }
}

}  // namespace
}  // namespace maquette::firmware
