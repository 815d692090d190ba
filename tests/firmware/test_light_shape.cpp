#include "firmware/light_shape.hpp"

#include <cmath>

#include "firmware/arithmetic/elementary.hpp"
#include "tests/catch.hpp"
#include "tests/firmware/random_cases.hpp"

namespace maquette::firmware {
namespace {

struct OneLight {
  explicit OneLight(const LightShape<double>& given) : shape(given), axis(given.axis) {
    frame.database.light_shapes = &shape;
    frame.prepared.light_axes = &axis;
  }

  [[nodiscard]] double share(const Vector<double>& to_light, double distance) const {
    return shaped_share(frame, 0, to_light, distance);
  }

  LightShape<double> shape;
  Vector<double> axis;
  Frame<double> frame{};
};

TEST_CASE("A near light has its intensity at its distance and a quarter at twice that") {
  trial::Random random(1101);
  for (int i = 0; i < 200; ++i) {
    const double distance = random.magnitude(0.01, 1000);
    const OneLight near({distance * distance, {0, 0, 0}, 0, 0});
    const Vector<double> any = random.direction();
    CHECK(near.share(any, distance) == Approx(1));
    CHECK(near.share(any, 2 * distance) == Approx(0.25));
    CHECK(near.share(any, distance / 3) == Approx(9));
  }
}

TEST_CASE("A spot is whole within its angle, nothing beyond its edge and falls between them") {
  trial::Random random(1102);
  for (int i = 0; i < 200; ++i) {
    const double inner = random.uniform(0.01, 1.5);
    const double outer = inner + random.uniform(0.02, 0.2);
    const Vector<double> axis = random.direction();
    const OneLight spot({0, axis, std::cos(outer), 1 / (std::cos(inner) - std::cos(outer))});
    const auto at = [&](double angle) {
      return spot.share(-random.direction_around(axis, std::cos(angle)), 5);
    };
    CHECK(at(inner * 0.99) == Approx(1));
    CHECK(at(outer * 1.001) == 0);
    double above = 1;
    for (int step = 1; step < 10; ++step) {
      const double share = at(inner + (outer - inner) * step / 10);
      CHECK(share < above);
      CHECK(share > 0);
      above = share;
    }
    const double middle = std::acos((std::cos(inner) + std::cos(outer)) / 2);
    CHECK(at(middle) == Approx(0.5).epsilon(1e-6));
  }
}

TEST_CASE("A spot may end behind itself") {
  const double inner = std::cos(170 * elementary::k_pi / 180);
  const OneLight spot({0, {0, 0, 1}, -1, 1 / (inner + 1)});
  CHECK(spot.share({0, 0, 1}, 5) == 0);
  CHECK(spot.share({0, 0, -1}, 5) == 1);
}

TEST_CASE("A spot's light falls off, too") {
  const OneLight spot({4, {0, 0, -1}, 0.5, 10});
  CHECK(spot.share({0, 0, 1}, 4) == Approx(0.25));
  CHECK(spot.share({0, 0, -1}, 4) == 0);
}

}  // namespace
}  // namespace maquette::firmware
