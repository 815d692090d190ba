#include "firmware/first_ahead.hpp"

#include <cmath>

#include "tests/catch.hpp"
#include "tests/firmware/test_frame.hpp"

namespace maquette::firmware {
namespace {

using trial::BuiltFrame;
using trial::Model;
using trial::Placement;
using trial::Random;

/// A ray that starts a little behind a face of a box, beside nothing else.
struct Start {
  RayQuery<double> query;
  bool is_leaving;  ///< through that face
};

Start random_start(Random& random, const Placement& box, SurfaceIndex medium) {
  const int axis = random.below(3);
  const double side = random.coin() ? 1 : -1;
  Vector<double> local = random.in_cube(0.5);
  local[axis] = side * (1 - random.magnitude(1e-9, 1e-4));
  Vector<double> outward(0, 0, 0);
  outward[axis] = side;
  const Vector<double> normal = glm::normalize(transform_normal(trial::inverse(box), outward));
  const double cosine = random.magnitude(1e-3, 1) * (random.coin() ? 1 : -1);
  const Vector<double> direction = random.direction_around(normal, cosine);
  Start start{{{transform_point(box, local), direction}, 1e6, false, 0, 0}, cosine > 0};
  start.query.medium = medium;
  return start;
}

TEST_CASE("A ray from the void that rounding has put into a body stands at the nearer face") {
  Random random(3101);
  for (int trial = 0; trial < 2000; ++trial) {
    const Placement box = random.placement(random.in_cube(10), random.magnitude(0.1, 10), 2);
    Model model;
    BuiltFrame<double> built(model, model.add(kind_of<box::Kind>, box));
    const Start start = random_start(random, box, k_void);
    const auto crossings = built.crossings_of(start.query);
    REQUIRE(crossings.size() == 2);
    SurfaceIndex before = 7;
    const std::int32_t first = first_ahead(built.frame, start.query, crossings.data(), 2, before);
    CHECK(before == k_void);
    CHECK(first == (start.is_leaving ? 2 : 0));
  }
}

TEST_CASE("A ray from matter that may be there starts where it does") {
  Random random(3102);
  for (int trial = 0; trial < 500; ++trial) {
    const Placement box = random.placement(random.in_cube(10), 1, 2);
    Model model;
    const SurfaceIndex glass = model.add(trial::glass_surface(1.5));
    BuiltFrame<double> built(model, model.add(kind_of<box::Kind>, box, glass));
    const Start start = random_start(random, box, glass);
    const auto crossings = built.crossings_of(start.query);
    SurfaceIndex before = k_void;
    CHECK(first_ahead(built.frame, start.query, crossings.data(), 2, before) == 1);
    CHECK(before == glass);
    // From the void the same ray starts at the face.
    RayQuery<double> outside = start.query;
    outside.medium = k_void;
    CHECK(first_ahead(built.frame, outside, crossings.data(), 2, before) != 1);
  }
}

TEST_CASE("A ray in glass starts in no opaque body") {
  Model model;
  const SurfaceIndex glass = model.add(trial::glass_surface(1.5));
  BuiltFrame<double> built(model, model.add(kind_of<box::Kind>, trial::moved({0, 0, 1})));
  RayQuery<double> query{{{0, 0, 1e-9}, {0, 0, 1}}, 1e6, false, 0, 0};
  const auto crossings = built.crossings_of(query);
  SurfaceIndex before = k_void;
  query.medium = glass;
  CHECK(first_ahead(built.frame, query, crossings.data(), 2, before) == 0);
  query.medium = 0;  // the eye in opaque matter
  CHECK(first_ahead(built.frame, query, crossings.data(), 2, before) == 1);
}

}  // namespace
}  // namespace maquette::firmware
