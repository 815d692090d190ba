#include "sim/database/observer_packing.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "sim/stability/random_cases.hpp"
#include "tests/catch.hpp"

namespace maquette::sim {
namespace {

constexpr PictureFormat k_format{64, 48};

/// Where the ray through a pixel meets a plane that is given by a frame: in the frame's x and y.
Vector3 seen_on(const firmware::Observer<double>& observer, double column, double row,
                const Placement& plane) {
  const Vector3 direction(observer.left + column * observer.step,
                          observer.top - row * observer.step, 1);
  const Vector3 eye = observer.from_screen[3];
  const Vector3 in_scene = Placement(observer.from_screen) * glm::dvec4(direction, 0);
  const Placement to_plane = trial::inverse(plane);
  const Vector3 from = to_plane * glm::dvec4(eye, 1);
  const Vector3 way = to_plane * glm::dvec4(in_scene, 0);
  return from - way * (from.z / way.z);
}

TEST_CASE("The corners of a placed screen are those of the picture, from wherever it is seen") {
  trial::Random random(1501);
  for (int i = 0; i < 500; ++i) {
    View view;
    const Placement place =
        firmware::concatenate(trial::moved(random.in_cube(10)), random.rotation());
    view.screen = Screen{};
    view.screen->width = 4;
    view.screen->height = 3;
    view.screen->placement = place;
    // Anywhere in front of the screen, far off its centre, too.
    view.eye = place * glm::dvec4(random.uniform(-8, 8), random.uniform(-8, 8),
                                  random.magnitude(0.1, 20), 1);
    const firmware::Observer<double> observer = observer_of(view, k_format);
    const Vector3 top_left = seen_on(observer, -0.5, -0.5, place);
    const Vector3 bottom_right = seen_on(observer, 63.5, 47.5, place);
    REQUIRE(top_left.x == Approx(-2).margin(1e-6));
    REQUIRE(top_left.y == Approx(1.5).margin(1e-6));
    REQUIRE(bottom_right.x == Approx(2).margin(1e-6));
    REQUIRE(bottom_right.y == Approx(-1.5).margin(1e-6));
  }
}

TEST_CASE("A screen placed where the eye would have it shows the same") {
  trial::Random random(1502);
  for (int i = 0; i < 200; ++i) {
    View view;
    view.eye = random.in_cube(5);
    view.target = view.eye + random.direction() * random.uniform(1, 9);
    view.up = random.direction();
    view.screen =
        Screen{random.uniform(0.1, 5), random.uniform(0.1, 5), random.uniform(0.1, 5), {}};
    const firmware::Observer<double> in_front = observer_of(view, k_format);
    const Placement from(in_front.from_screen);
    const Vector3 center = view.eye + Vector3(from[2]) * view.screen->distance;
    view.screen->placement = Placement(from[0], from[1], -from[2], center);
    const firmware::Observer<double> placed = observer_of(view, k_format);
    CHECK(placed.left == Approx(in_front.left));
    CHECK(placed.top == Approx(in_front.top));
    CHECK(placed.step == Approx(in_front.step));
    for (int axis = 0; axis < 4; ++axis) {
      CHECK(glm::length(placed.from_screen[axis] - in_front.from_screen[axis]) < 1e-9);
    }
  }
}

TEST_CASE("A scaled screen is seen like one of that size") {
  View view;
  view.eye = {0, 0, 5};
  view.screen = Screen{};
  view.screen->width = 2;
  view.screen->height = 1;
  view.screen->placement = trial::scaled({3, 3, 1});
  const firmware::Observer<double> scaled_up = observer_of(view, k_format);
  view.screen->placement = trial::unmoved();
  view.screen->width = 6;
  view.screen->height = 3;
  CHECK(observer_of(view, k_format).step == Approx(scaled_up.step));
  // A wide screen in a narrower picture: its width decides.
  CHECK(scaled_up.step == Approx(6.0 / 5 / 64));
}

/// The angle, in degrees, that so many pixels span around the middle.
double angle_deg(const firmware::Observer<double>& observer, int pixels) {
  return 2 * std::atan(observer.step * pixels / 2) * 180 / std::acos(-1.0);
}

TEST_CASE("A field of view spans the picture upwards or across, whatever its shape") {
  for (const PictureFormat format : {PictureFormat{768, 575}, PictureFormat{100, 300}}) {
    View view;
    view.field_of_view_deg = 40;
    CHECK(angle_deg(observer_of(view, format), format.height) == Approx(40));
    view.field_of_view_deg.reset();
    view.horizontal_field_of_view_deg = 40;
    CHECK(angle_deg(observer_of(view, format), format.width) == Approx(40));
  }
}

}  // namespace
}  // namespace maquette::sim
