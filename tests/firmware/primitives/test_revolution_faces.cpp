#include "firmware/primitives/revolution_faces.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/catch.hpp"
#include "tests/firmware/primitives/revolution_solids.hpp"

namespace maquette::firmware::revolution {
namespace {

using namespace trial;

/// The same sections, each halved again and again.
std::vector<double> halved(std::vector<double> points, int times) {
  for (int time = 0; time < times; ++time) {
    std::vector<double> finer = {points[0], points[1]};
    for (std::size_t section = 0; section + 7 < points.size(); section += 6) {
      Cubic<double> lower[2];
      Cubic<double> upper[2];
      for (int k = 0; k < 2; ++k) {
        bisect(coordinate(points.data() + section + k), lower[k], upper[k]);
      }
      for (const auto& half : {lower, upper}) {
        for (int i = 1; i < 4; ++i) {
          finer.insert(finer.end(), {half[0].at[i], half[1].at[i]});
        }
      }
    }
    points = finer;
  }
  return points;
}

TEMPLATE_TEST_CASE("A generatrix of hundreds of sections has the chords and normals of one of few",
                   "", float, double) {
  using Real = TestType;
  Random random(1807);
  int compared = 0;
  for (int i = 0; i < 30; ++i) {
    const Solid few = random.coin() ? random_vase(random) : random_ring(random, 0.3);
    const Generatrix<double> curve = generatrix(few.parameters.data());
    const std::vector<double> points(curve.points, curve.section(curve.sections) + 2);
    const std::vector<double> fine = halved(points, 6);
    Solid many;
    many.parameters = converted<double>(given_sections(fine, curve.is_open));
    many.as_float.assign(many.parameters.begin(), many.parameters.end());
    REQUIRE(generatrix(many.parameters.data()).sections == 64 * curve.sections);
    for (int k = 0; k < 60; ++k) {
      const Ray<double> ray = random_ray(random, 4);
      const Hits<Real> coarse = hits_on<Real>(few, ray.origin, ray.direction);
      const Hits<Real> dense = hits_on<Real>(many, ray.origin, ray.direction);
      CAPTURE(i, k, coarse.count, dense.count);
      REQUIRE(dense.count % 2 == 0);
      if (coarse.count != dense.count) {
        continue;  // where rounding decides whether a ray grazes
      }
      for (int j = 0; j < coarse.count; ++j) {
        const double apart = static_cast<double>(coarse.hits[j].distance - dense.hits[j].distance);
        const Vector<Real> p =
            Vector<Real>(ray.origin) + Vector<Real>(ray.direction) * dense.hits[j].distance;
        const auto on_few = settle(p, coarse.hits[j].face, parameters_of<Real>(few));
        const auto on_many = settle(p, dense.hits[j].face, parameters_of<Real>(many));
        if (std::fabs(apart) > 1e-3 || glm::length(Vector<double>(on_few.position) -
                                                   Vector<double>(on_many.position)) > 1e-4) {
          continue;  // the other part of a fold, or a grazing ray
        }
        ++compared;
        const double cosine = glm::dot(glm::normalize(Vector<double>(on_few.normal)),
                                       glm::normalize(Vector<double>(on_many.normal)));
        REQUIRE(cosine > 0.9);
      }
    }
  }
  CHECK(compared > 1000);
}

TEST_CASE("Of a ray through more faces than there is room for the nearest are met") {
  // Fins above one another, through which rays go along the axis.
  constexpr int k_fins = 300;
  std::vector<double> control;
  for (int i = 0; i < 4 * k_fins; ++i) {
    control.insert(control.end(), {i % 4 < 2 ? 0.3 : 1, 2.0 * i / (4 * k_fins) - 1});
  }
  const Solid fins = solid_of(control, true);
  REQUIRE(generatrix(fins.parameters.data()).sections == 4 * k_fins - 3);
  const Hits<double> up = hits_on<double>(fins, {0.65, 0, -2}, {0, 0, 1});
  const Hits<double> down = hits_on<double>(fins, {0.65, 0, 2}, {0, 0, -1});
  CHECK(up.count > 100);
  CHECK(up.count < 2 * k_fins);
  const double pitch = 2.0 / k_fins;
  for (int i = 4; i < std::min(up.count, down.count); ++i) {
    CHECK(up.hits[i].distance - up.hits[i - 2].distance == Approx(pitch).epsilon(1e-6));
    CHECK(down.hits[i].distance - down.hits[i - 2].distance == Approx(pitch).epsilon(1e-6));
  }
  CHECK(up.hits[0].distance < 1 + pitch);
  const Hits<double> middle = hits_on<double>(fins, {0.65, 0, 0}, {0, 0, 1});
  for (int i = 0; i < middle.count; ++i) {
    CHECK(middle.hits[i].distance > -2 * pitch);
  }
  CHECK(middle.hits[middle.count - 1].distance > 0.3);
}

}  // namespace
}  // namespace maquette::firmware::revolution
