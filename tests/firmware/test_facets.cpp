#include "firmware/facets.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/facet_surface.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

using Power = cosine_power::Kind;
using Gaussian = gaussian::Kind;
using Ellipsoids = trowbridge_reitz::Kind;

/// The value of a kind as found in a list.
template <class Kind, class List>
double value_in(const Surface<double>& surface, double cosine) {
  Surface<double> of_kind = surface;
  of_kind.facets = facet_kind_of<Kind>;
  return facet_value(List{}, of_kind, cosine);
}

TEST_CASE("A surface has the values of its own distribution, however many a table lists") {
  trial::Random random(906);
  for (int i = 0; i < 1000; ++i) {
    const double cosine = random.uniform(0, 1);
    const Surface<double> surface =
        trial::facet_surface(facet_kind_of<Power>, random.uniform(0.01, 1.5));
    const double power = cosine_power::distribution(surface, cosine);
    const double gauss = gaussian::distribution(surface, cosine);
    const double ratio = trowbridge_reitz::distribution(surface, cosine);
    REQUIRE(value_in<Power, KindList<Power>>(surface, cosine) == power);
    REQUIRE(value_in<Power, KindList<Gaussian, Power>>(surface, cosine) == power);
    REQUIRE(value_in<Gaussian, KindList<Gaussian, Power>>(surface, cosine) == gauss);
    REQUIRE(value_in<Power, FacetKinds>(surface, cosine) == power);
    REQUIRE(value_in<Gaussian, FacetKinds>(surface, cosine) == gauss);
    REQUIRE(value_in<Ellipsoids, FacetKinds>(surface, cosine) == ratio);
    // Four rows: the third and the fourth stand in a switch of their own.
    REQUIRE(value_in<Gaussian, KindList<Power, Ellipsoids, Gaussian, Power>>(surface, cosine) ==
            gauss);
    REQUIRE(value_in<Gaussian, KindList<Power, Ellipsoids, Power, Gaussian>>(surface, cosine) ==
            gauss);
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
    REQUIRE(facet_attenuation(half.z, view.z, light.z, v_h, glm::dot(light, half)) ==
            Approx(one_way).epsilon(1e-9));
  }
  CHECK(facet_attenuation(1.0, 1.0, 1.0, 1.0) == 1);
}

}  // namespace
}  // namespace maquette::firmware
